// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/scene_files.h>

#include <fmt/format.h>
#include <lightcuts/render/files/text.h>

namespace lightcuts {

bool is_scene_file(const std::filesystem::path& file) {
  return std::ranges::find(scene_extensions, lower_extension(file)) != scene_extensions.end();
}

std::string scene_extensions_text(std::string_view mark) {
  std::string text;
  for (const std::string_view& extension : scene_extensions) {
    if (&extension == &scene_extensions.back())
      text += " or ";
    else if (!text.empty())
      text += ", ";
    text += fmt::format("{0}{1}{0}", mark, extension);
  }
  return text;
}

} // namespace lightcuts
