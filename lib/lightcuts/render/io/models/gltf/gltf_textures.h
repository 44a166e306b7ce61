// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <lightcuts/render/io/models/gltf/gltf_file.h>
#include <lightcuts/render/io/models/model_textures.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A textureInfo: a texture, and which texture coordinates it is looked up with.
struct GltfTexture {
  SurfaceTexture texture;
  std::size_t uv_set = 0; ///< TEXCOORD_n
  glm::dvec2 scale{1}, offset{0};
  double rotation = 0; ///< radians

  /// The coordinates as Texture::at takes them: KHR_texture_transform's scale, then its turn,
  /// counter-clockwise as one sees the image, then its offset; and v upwards.
  [[nodiscard]] glm::vec2 at(const glm::vec2& uv) const;
};

/// The textures of a glTF file.
class GltfTextures {
public:
  /// All arguments must outlive it.
  GltfTextures(const GltfFile& file, const FileAccess& access, Scene& scene)
      : file_(file), textures_(file.path(), access, scene) {}

  /// What the member of a material describes; nothing where it is not there, or its image cannot be
  /// read, which is noted.
  std::optional<GltfTexture> in(const gltf::Json& object, const char* key);

  void note_once(const std::string& text) { textures_.note_once(text); }

private:
  ModelTextures::Index image(std::size_t index);

  const GltfFile& file_;
  ModelTextures textures_;
};

} // namespace lightcuts
