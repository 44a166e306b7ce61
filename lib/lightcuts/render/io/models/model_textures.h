// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Adds the images that a model's materials use to a scene, each once.
class ModelTextures {
public:
  /// Index into Scene::textures; nothing where the image cannot be read, which is noted once.
  using Index = std::optional<std::uint32_t>;

  /// All arguments must outlive it.
  ModelTextures(const std::filesystem::path& model, const FileAccess& access, Scene& scene)
      : model_(model), access_(access), scene_(scene) {}

  /// An image file named relative to the model's; of a URI, %20 and the like count as characters,
  /// else backslashes as slashes, where no such file is there.
  Index of_file(const std::string& name, bool is_uri);

  /// An image within the model: its number there, bytes, and an extension ("png").
  Index embedded(std::size_t number, std::string_view bytes, const std::string& extension);

  /// Adds "MODEL: TEXT" to the scene's notes, once.
  void note_once(const std::string& text);

private:
  template <class Read>
  Index once(const std::string& key, const std::string& title, const Read& read);

  const std::filesystem::path& model_;
  const FileAccess& access_;
  Scene& scene_;
  std::map<std::string, Index> known_;
  std::set<std::string> notes_;
};

/// A URI's %20 and the like as characters.
[[nodiscard]] std::string percent_decoded(const std::string& uri);

} // namespace lightcuts
