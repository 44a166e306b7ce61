// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_materials.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

constexpr std::size_t default_material = std::numeric_limits<std::size_t>::max();

float unit_factor(const gltf::Json& object, const char* key) {
  const auto value = static_cast<float>(gltf::number_in(object, key, 1));
  if (!(value >= 0 && value <= 1))
    throw InputError(fault_of(value), fmt::format("{} is {}, expected 0 to 1", key, value));
  return value;
}

/// Reflectance at normal incidence of what has this index of refraction; 0.04 of 1.5. KHR's 0 means
/// 1 at all angles.
float dielectric_f0(const gltf::Json& source) {
  const gltf::Json* extension = gltf::extension_of(source, "KHR_materials_ior");
  if (!extension || !extension->contains("ior")) return 0.04F;
  const double ior = gltf::number_in(*extension, "ior", 1.5);
  if (ior != 0 && !(ior >= 1))
    throw InputError(fault_of(ior), fmt::format("ior is {}, expected 1 or more, or 0", ior));
  return static_cast<float>((ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)));
}

CookTorrance lobe_of(const glm::vec3& f0, float roughness) {
  return {f0, std::max(roughness * roughness, CookTorrance::min_alpha)};
}

} // namespace

const GltfMaterial& GltfMaterials::material(std::optional<std::size_t> index) {
  const std::size_t key = index.value_or(default_material);
  auto found = materials_.find(key);
  if (found == materials_.end()) found = materials_.emplace(key, made(index)).first;
  return found->second;
}

std::uint32_t GltfMaterials::surface(std::optional<std::size_t> index, bool with_base,
                                     bool with_emission) {
  const GltfMaterial& source = material(index);
  with_base = with_base && source.base;
  with_emission = with_emission && source.emission;
  const auto [found, is_new] =
      surfaces_.emplace(std::tuple(index.value_or(default_material), with_base, with_emission),
                        static_cast<std::uint32_t>(scene_.surfaces.size()));
  if (is_new) {
    Surface surface = source.surface;
    if (with_base) surface.texture = source.base->texture;
    if (with_emission) surface.emission_texture = source.emission->texture;
    scene_.surfaces.push_back(std::move(surface));
  }
  return found->second;
}

GltfMaterial GltfMaterials::made(std::optional<std::size_t> index) {
  static const gltf::Json nothing = gltf::Json::object();
  const gltf::Json& source = index ? file_.item("materials", *index) : nothing;
  GltfMaterial material;
  material.surface.name =
      index ? file_.name_of("materials", "material", *index) : "DefaultMaterial";
  const std::string where =
      fmt::format("{}: material '{}'", file_.path().string(), material.surface.name);
  try {
    const gltf::Json* glossy = gltf::extension_of(source, "KHR_materials_pbrSpecularGlossiness");
    if (glossy)
      read_specular_glossiness(*glossy, material);
    else
      read_metallic_roughness(source, material);
    validate(material.surface.material);
    read_emission(source, material);
  } catch (const InputError& error) {
    throw InputError(error.fault(), one_line(fmt::format("{}: {}", where, error.what())));
  }
  count_unused(source, material);
  return material;
}

/// glTF 2.0, appendix B, with a diffuse part that does not vary with the angle.
void GltfMaterials::read_metallic_roughness(const gltf::Json& source, GltfMaterial& material) {
  const gltf::Json& pbr = gltf::object_in(source, "pbrMetallicRoughness");
  const glm::vec3 base(gltf::vector_in(pbr, "baseColorFactor", glm::dvec3(1)));
  const float metallic = unit_factor(pbr, "metallicFactor");
  const float roughness = unit_factor(pbr, "roughnessFactor");
  const float dielectric = dielectric_f0(source);
  material.surface.material = {base * (1 - metallic) * (1 - dielectric),
                               lobe_of(glm::mix(glm::vec3(dielectric), base, metallic), roughness)};
  material.surface.tinted_f0 = base * metallic;
  material.base = textures_.in(pbr, "baseColorTexture");
}

/// Energy that is reflected specularly is not there to be reflected diffusely: the extension takes
/// the largest component for all.
void GltfMaterials::read_specular_glossiness(const gltf::Json& source, GltfMaterial& material) {
  const glm::vec3 diffuse(gltf::vector_in(source, "diffuseFactor", glm::dvec3(1)));
  const glm::vec3 f0(gltf::vector_in(source, "specularFactor", glm::dvec3(1)));
  const float glossiness = unit_factor(source, "glossinessFactor");
  const float left = 1 - std::max({f0.r, f0.g, f0.b});
  material.surface.material = {diffuse * std::max(left, 0.0F), lobe_of(f0, 1 - glossiness)};
  material.base = textures_.in(source, "diffuseTexture");
}

void GltfMaterials::read_emission(const gltf::Json& source, GltfMaterial& material) {
  const gltf::Json* extension = gltf::extension_of(source, "KHR_materials_emissive_strength");
  const double strength = extension ? gltf::number_in(*extension, "emissiveStrength", 1) : 1;
  glm::vec3& emission = material.surface.emission;
  emission = glm::vec3(strength * gltf::vector_in(source, "emissiveFactor", glm::dvec3(0)));
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(emission[c]) || emission[c] < 0)
      throw InputError(fault_of(emission[c]),
                       fmt::format("emission.{} is {}, out of its domain", "rgb"[c], emission[c]));
  if (emission != glm::vec3(0)) material.emission = textures_.in(source, "emissiveTexture");
}

void GltfMaterials::count_unused(const gltf::Json& source, const GltfMaterial& material) {
  const gltf::Json& pbr = gltf::object_in(source, "pbrMetallicRoughness");
  const gltf::Json* glossy = gltf::extension_of(source, "KHR_materials_pbrSpecularGlossiness");
  const gltf::Json& colour = glossy ? *glossy : pbr;
  const char* factor = glossy ? "diffuseFactor" : "baseColorFactor";
  const gltf::Json& rgba = gltf::list_in(colour, factor);
  const double alpha = rgba.size() > 3 && rgba[3].is_number() ? rgba[3].get<double>() : 1;
  const std::string mode = gltf::text_in(source, "alphaMode", "OPAQUE");
  if (mode != "OPAQUE" && (alpha < 1 || material.base)) ++unused_["transparent material"];
  if (material.surface.emission != glm::vec3(0) && gltf::truth_in(source, "doubleSided", false))
    ++unused_["two-sided emitter"];
  if (source.contains("normalTexture")) ++unused_["normal texture"];
  if (glossy && glossy->contains("specularGlossinessTexture"))
    ++unused_["specular-glossiness texture"];
  if (!glossy && pbr.contains("metallicRoughnessTexture")) ++unused_["metallic-roughness texture"];
}

void GltfMaterials::finish() {
  for (const auto& [what, count] : unused_) {
    const char* done = what == "transparent material" ? "drawn opaque"
                       : what == "two-sided emitter"
                           ? "lights its front alone: area lights are one-sided"
                       : what == "normal texture" ? "left out"
                                                  : "left out: the factors are used";
    textures_.note_once(fmt::format("{} {}", counted(count, what), done));
  }
}

} // namespace lightcuts
