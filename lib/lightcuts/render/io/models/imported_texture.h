// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <assimp/scene.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The base-colour texture of a material, as its file has it.
struct ImportedTexture {
  std::uint32_t index; ///< into Scene::textures
  TextureWrap wrap;
  unsigned uv_set;         ///< which of a mesh's texture coordinates
  glm::vec2 scale, offset; ///< the texture's coordinates are scale * the mesh's + offset
};

/// Adds the images that a model's materials use to a scene, each once.
class TextureImport {
public:
  /// All arguments must outlive it.
  TextureImport(const std::filesystem::path& model, bool is_gltf, const aiScene& source,
                Scene& scene)
      : model_(model), is_gltf_(is_gltf), source_(source), scene_(scene) {}

  /// The material's base-colour texture; nothing where it has none, or one whose image cannot be
  /// read, which is noted once per image. What of a texture is left out is noted, too.
  std::optional<ImportedTexture> of(const aiMaterial& material);

private:
  /// Index into Scene::textures.
  using Index = std::optional<std::uint32_t>;

  Index index_of(const std::string& name);
  Index add(const std::string& name);
  void note_unused(const aiMaterial& material);
  void apply_transform(const aiUVTransform& transform, const std::string& name,
                       ImportedTexture& texture);
  void note_once(const std::string& name, const std::string& text);
  [[nodiscard]] Texture read(const std::string& name) const;

  const std::filesystem::path& model_;
  bool is_gltf_;
  const aiScene& source_;
  Scene& scene_;
  std::map<std::string, Index> known_; ///< by normalised name
  std::set<std::string> notes_;
};

} // namespace lightcuts
