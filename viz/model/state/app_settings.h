// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/render/io/images/colour_map.h>

namespace lightcuts::viz {

/// What the window remembers from one time to the next, apart from any scene.
struct AppSettings {
  static constexpr std::size_t most_recent = 12;

  glm::ivec2 window_size{1280, 800}; ///< screen coordinates
  float details_share = 0.42F;       ///< of the window's width for the panels at the right
  float tree_share = 0.3F;           ///< of the window's height for the tree
  ColourMap colour_map = ColourMap::inferno;
  std::vector<std::string> recent; ///< scenes, the latest first

  /// Puts the scene first; it may be one of `recent`.
  void remember(std::string scene);
  bool operator==(const AppSettings&) const = default;
};

/// $XDG_CONFIG_HOME/lightcuts-viz, or ~/.config/lightcuts-viz; empty where neither is known.
[[nodiscard]] std::filesystem::path config_folder();

/// The settings of the folder; as by default, with a message in `problem`, where there are none
/// that can be read. No file at all is no problem.
[[nodiscard]] AppSettings load_settings(const std::filesystem::path& folder, std::string& problem);
/// Makes the folder. Throws InputError, naming the file, where it cannot be written.
void save_settings(const AppSettings& settings, const std::filesystem::path& folder);

} // namespace lightcuts::viz
