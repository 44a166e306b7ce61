// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/render/images/colour_map.h>

namespace lightcuts::viz {

/// Kept by the window from one time to the next, apart from any scene.
struct AppSettings {
  static constexpr std::size_t most_recent = 12;

  glm::uvec2 window_size{1280, 800}; ///< screen coordinates
  float details_share = 0.42F;       ///< of the window's width for the panels at the right
  float tree_share = 0.3F;           ///< of the window's height for the tree
  ColourMap colour_map = ColourMap::inferno;
  std::vector<std::string> recent; ///< scenes, the latest first

  /// Puts the scene first; it may be one of `recent`.
  void remember(std::string scene);
  bool operator==(const AppSettings&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    constexpr Domain size{.least = 240, .most = 16384, .optional = true};
    constexpr Domain share{.least = 0.0625, .most = 0.875, .optional = true};
    field("window_size", &AppSettings::window_size, size);
    field("details_share", &AppSettings::details_share, share);
    field("tree_share", &AppSettings::tree_share, share);
    field("colour_map", &AppSettings::colour_map, domain::optional);
    field("recent", &AppSettings::recent, domain::optional);
  }
};

/// $XDG_CONFIG_HOME/lightcuts-viz, or ~/.config/lightcuts-viz; empty where neither is known.
[[nodiscard]] std::filesystem::path config_folder();

/// The settings of the folder; as by default, with a message in `problem`, where there are none
/// that can be read. No file at all is no problem.
[[nodiscard]] AppSettings load_settings(const std::filesystem::path& folder, std::string& problem);
/// Writes them, numbers moved into their domains and only the latest `most_recent` scenes; makes
/// the folder. Throws InputError, naming the file, where it cannot be written.
void save_settings(const AppSettings& settings, const std::filesystem::path& folder);

} // namespace lightcuts::viz
