// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/imported_material.h>

#include <algorithm>
#include <cmath>

#include <assimp/GltfMaterial.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <lightcuts/core/input_error.h>

namespace lightcuts {
namespace {

constexpr float dielectric = 0.04F; // reflectance of glass and plastic at normal incidence

glm::vec3 colour(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  aiColor4D c(0, 0, 0, 1);
  material.Get(key, type, index, c);
  return {c.r, c.g, c.b};
}

float number(const aiMaterial& material, const char* key, unsigned type, unsigned index,
             float otherwise) {
  material.Get(key, type, index, otherwise);
  return otherwise;
}

Material from_mtl(const aiMaterial& source, const std::string& where,
                  std::vector<std::string>& notes) {
  float exponent = number(source, AI_MATKEY_SHININESS, 0);
  if (std::isfinite(exponent) && exponent > Phong::max_exponent) {
    notes.push_back(
        fmt::format("{}: exponent {} is clamped to {}", where, exponent, Phong::max_exponent));
    exponent = Phong::max_exponent;
  }
  const Phong phong{colour(source, AI_MATKEY_COLOR_SPECULAR), exponent};
  phong.validate(); // even if it is black, and left out
  return diffuse_and_phong(colour(source, AI_MATKEY_COLOR_DIFFUSE), phong.reflectance, exponent);
}

float unit_factor(float value, const char* name) {
  if (!(value >= 0 && value <= 1))
    throw InputError(fault_of(value), fmt::format("{} is {}, expected 0 to 1", name, value));
  return value;
}

/// glTF 2.0, appendix B, with a diffuse part that does not vary with the angle.
Material from_metallic_roughness(const aiMaterial& source) {
  const glm::vec3 base = colour(source, AI_MATKEY_BASE_COLOR);
  const float metallic =
      unit_factor(number(source, AI_MATKEY_METALLIC_FACTOR, 1), "metallicFactor");
  const float roughness =
      unit_factor(number(source, AI_MATKEY_ROUGHNESS_FACTOR, 1), "roughnessFactor");
  return {base * (1 - metallic) * (1 - dielectric),
          CookTorrance{glm::mix(glm::vec3(dielectric), base, metallic),
                       std::max(roughness * roughness, CookTorrance::min_alpha)}};
}

} // namespace

Surface surface_of(const aiMaterial& source, bool is_gltf, const std::string& where,
                   std::vector<std::string>& notes) {
  Surface surface;
  surface.name = source.GetName().C_Str();
  surface.emission = colour(source, AI_MATKEY_COLOR_EMISSIVE);
  try {
    surface.material = is_gltf ? from_metallic_roughness(source) : from_mtl(source, where, notes);
    validate(surface.material);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("{}: {}", where, error.what()));
  }
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(surface.emission[c]) || surface.emission[c] < 0)
      throw InputError(fault_of(surface.emission[c]),
                       fmt::format("{}: emission.{} is {}, out of its domain", where, "rgb"[c],
                                   surface.emission[c]));
  return surface;
}

glm::vec3 tinted_f0(const aiMaterial& source, bool is_gltf) {
  if (!is_gltf) return glm::vec3(0);
  return colour(source, AI_MATKEY_BASE_COLOR) * number(source, AI_MATKEY_METALLIC_FACTOR, 1);
}

} // namespace lightcuts
