// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <lightcuts/render/io/models/gltf/gltf_file.h>
#include <lightcuts/render/io/models/gltf/gltf_textures.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A material of a glTF file with its textures.
struct GltfMaterial {
  Surface surface; ///< without textures
  std::optional<GltfTexture> base, emission;
};

/// The materials of a glTF file, as model_import.h says, each read when it is first used.
class GltfMaterials {
public:
  /// All arguments must outlive it.
  GltfMaterials(const GltfFile& file, const FileAccess& access, Scene& scene)
      : file_(file), scene_(scene), textures_(file, access, scene) {}

  /// The material of that index; glTF's default without one.
  const GltfMaterial& material(std::optional<std::size_t> index);

  /// The surface of the material, with the textures that a mesh has coordinates for.
  std::uint32_t surface(std::optional<std::size_t> index, bool with_base, bool with_emission);

  /// Notes that concern all of the file.
  void finish();

private:
  GltfMaterial made(std::optional<std::size_t> index);
  void read_metallic_roughness(const gltf::Json& source, GltfMaterial& material);
  void read_specular_glossiness(const gltf::Json& source, GltfMaterial& material);
  void read_emission(const gltf::Json& source, GltfMaterial& material);
  void count_unused(const gltf::Json& source, const GltfMaterial& material);

  const GltfFile& file_;
  Scene& scene_;
  GltfTextures textures_;
  std::map<std::size_t, GltfMaterial> materials_; ///< by index, glTF's default last
  std::map<std::tuple<std::size_t, bool, bool>, std::uint32_t> surfaces_;
  std::map<std::string, std::size_t> unused_; ///< materials that have what is left out
};

} // namespace lightcuts
