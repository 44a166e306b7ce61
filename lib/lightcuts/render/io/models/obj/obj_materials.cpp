// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj/obj_materials.h>

#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

constexpr float grey = 0.6F; // of faces whose material says nothing of it

Material phong_of(const MtlMaterial& source, const std::string& where,
                  std::vector<std::string>& notes) {
  float exponent = source.exponent;
  if (std::isfinite(exponent) && exponent > Phong::max_exponent) {
    notes.push_back(
        fmt::format("{}: exponent {} is clamped to {}", where, exponent, Phong::max_exponent));
    exponent = Phong::max_exponent;
  }
  const glm::vec3 diffuse = source.diffuse.value_or(glm::vec3(source.diffuse_map ? 1 : grey));
  const Phong phong{source.specular, exponent};
  phong.validate(); // even if it is black, and left out
  Material material = diffuse_and_phong(diffuse, phong.reflectance, exponent);
  validate(material);
  return material;
}

Surface plain_surface(const MtlMaterial& source, const std::string& where,
                      std::vector<std::string>& notes) {
  Surface surface;
  surface.name = source.name;
  // A map of what is emitted, without a factor for it, is meant as it is.
  surface.emission = source.emission_map && !source.has_emission ? glm::vec3(1) : source.emission;
  try {
    surface.material = phong_of(source, where, notes);
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

TextureWrap wrap_of(const MtlMap& map) {
  const Wrap wrap = map.clamp ? Wrap::clamp : Wrap::repeat;
  return {wrap, wrap};
}

} // namespace

void ObjMaterials::read_libraries(const std::string& rest, const std::vector<std::string>& names) {
  if (read_library(rest)) return;
  bool any = false;
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    const bool found = names.size() > 1 && read_library(name);
    any = any || found;
    if (!found) missing.push_back(name);
  }
  if (!any) missing = {rest};
  library_missing_ = library_missing_ || !missing.empty();
  for (const std::string& name : missing)
    textures_.note_once(
        fmt::format("material library '{}' not found: its materials are grey", name));
}

bool ObjMaterials::read_library(const std::string& name) {
  std::string slashes = name;
  for (char& c : slashes)
    if (c == '\\') c = '/';
  for (const std::string& spelling : {name, slashes}) {
    const std::filesystem::path library = file_.parent_path() / spelling;
    std::error_code error;
    if (spelling.find('\0') != std::string::npos || !std::filesystem::exists(library, error))
      continue;
    access_.require(library, fmt::format("{}: material library '{}'", file_.string(), name));
    if (!read_.insert(library.lexically_normal().string()).second) return true;
    MtlFile mtl = read_mtl(library);
    for (const std::string& note : mtl.notes)
      scene_.notes.push_back(one_line(fmt::format("{}: {}", library.string(), note)));
    for (MtlMaterial& material : mtl.materials) {
      if (!by_name_.emplace(material.name, materials_.size()).second) {
        textures_.note_once(
            fmt::format("material '{}' is there twice: the first counts", material.name));
        continue;
      }
      materials_.push_back(std::move(material));
    }
    return true;
  }
  return false;
}

std::size_t ObjMaterials::named(const std::string& name) {
  const auto [found, is_new] = by_name_.emplace(name, materials_.size());
  if (is_new) {
    materials_.push_back({.name = name});
    if (!library_missing_)
      textures_.note_once(fmt::format("material '{}' is in no library: grey", name));
  }
  return found->second;
}

std::size_t ObjMaterials::unnamed() {
  if (!unnamed_) {
    unnamed_ = materials_.size();
    materials_.push_back({.name = "DefaultMaterial"});
  }
  return *unnamed_;
}

ObjMaterials::Use ObjMaterials::use(std::size_t material, bool has_coordinates) {
  surfaces_.resize(materials_.size());
  Surfaces& known = surfaces_[material];
  std::optional<Use>& use = has_coordinates ? known.textured : known.plain;
  if (use) return *use;
  const MtlMaterial& source = materials_[material];
  const bool has_map = source.diffuse_map || source.emission_map;
  std::optional<Use>& other = has_coordinates ? known.plain : known.textured;
  if (!has_map && other) return *(use = other);
  return *(use = made(material, has_coordinates));
}

ObjMaterials::Use ObjMaterials::made(std::size_t material, bool has_coordinates) {
  const MtlMaterial& source = materials_[material];
  const std::string where = fmt::format("{}: material '{}'", file_.string(), source.name);
  Surface surface = plain_surface(source, where, scene_.notes);
  if (source.opacity < 1 && !surfaces_[material].plain && !surfaces_[material].textured)
    ++transparent_;
  Use use{static_cast<std::uint32_t>(scene_.surfaces.size())};
  if (has_coordinates && source.diffuse_map)
    if (const auto index = textures_.of_file(source.diffuse_map->file, false)) {
      surface.texture = {*index, wrap_of(*source.diffuse_map)};
      use.map = &*source.diffuse_map;
    }
  if (has_coordinates && source.emission_map && surface.emission != glm::vec3(0))
    if (const auto index = textures_.of_file(source.emission_map->file, false)) {
      surface.emission_texture = {*index, wrap_of(*source.emission_map)};
      use.emission_map = &*source.emission_map;
    }
  if (!has_coordinates && (source.diffuse_map || source.emission_map)) ++without_uv_;
  scene_.surfaces.push_back(std::move(surface));
  return use;
}

void ObjMaterials::finish() {
  if (without_uv_ > 0)
    textures_.note_once("a texture without texture coordinates on " +
                        counted(without_uv_, "mesh part") + ": the factor colour is used");
  if (transparent_ > 0)
    textures_.note_once(counted(transparent_, "transparent material") + " drawn opaque");
}

} // namespace lightcuts
