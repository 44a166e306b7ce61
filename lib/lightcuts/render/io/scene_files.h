// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include <lightcuts/render/io/models/model_import.h>

namespace lightcuts {

/// The extension of load_scene_json()'s files.
inline constexpr std::string_view scene_json_extension = ".json";

/// The extensions of all files that open_scene() reads; upper and lower case do not matter.
inline constexpr auto scene_extensions = [] {
  std::array<std::string_view, 1 + model_extensions.size()> all{scene_json_extension};
  std::copy(model_extensions.begin(), model_extensions.end(), all.begin() + 1);
  return all;
}();

/// Whether the file's name has one of scene_extensions.
[[nodiscard]] bool is_scene_file(const std::filesystem::path& file);

/// For people: ".json, .obj or .gltf", each extension between two marks.
[[nodiscard]] std::string scene_extensions_text(std::string_view mark = "");

} // namespace lightcuts
