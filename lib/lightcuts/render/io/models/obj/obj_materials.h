// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/io/models/model_textures.h>
#include <lightcuts/render/io/models/obj/mtl_file.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The materials that an `.obj` names, as surfaces of a scene.
class ObjMaterials {
public:
  /// All arguments must outlive it.
  ObjMaterials(const std::filesystem::path& file, const FileAccess& access, Scene& scene)
      : file_(file), access_(access), scene_(scene), textures_(file, access, scene) {}

  /// Reads what an `mtllib` names: one file, blanks in its name or not, else one for each word.
  void read_libraries(const std::string& rest, const std::vector<std::string>& names);

  /// Which of materials() has the name; one of its own for a name that no library has.
  std::size_t named(const std::string& name);
  /// That of faces before any `usemtl`.
  std::size_t unnamed();

  /// How a material's faces are textured.
  struct Use {
    std::uint32_t surface;
    const MtlMap* map = nullptr;          ///< of the base colour, if it has one that is read
    const MtlMap* emission_map = nullptr; ///< likewise
  };
  /// The material's surface with its textures, or without for faces that lack coordinates.
  Use use(std::size_t material, bool has_coordinates);

  /// Notes that concern all of the file.
  void finish();

private:
  struct Surfaces {
    std::optional<Use> textured, plain;
  };

  bool read_library(const std::string& name);
  Use made(std::size_t material, bool has_coordinates);

  const std::filesystem::path& file_;
  const FileAccess& access_;
  Scene& scene_;
  ModelTextures textures_;
  std::deque<MtlMaterial> materials_; // their addresses stay
  std::map<std::string, std::size_t> by_name_;
  std::vector<Surfaces> surfaces_;
  std::optional<std::size_t> unnamed_;
  std::set<std::string> read_; ///< libraries
  std::size_t transparent_ = 0, without_uv_ = 0;
  bool library_missing_ = false;
};

} // namespace lightcuts
