// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

namespace lightcuts {

/// The whole file. Throws InputError where it cannot be opened or read.
inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  // A folder opens, but does not read.
  if (!in || std::filesystem::is_directory(file))
    throw InputError(InputFault::unreadable_file, fmt::format("{}: cannot open", file.string()));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad())
    throw InputError(InputFault::unreadable_file, fmt::format("{}: cannot read", file.string()));
  return text;
}

/// The file name's ending, dot included, in lower case.
inline std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Somebody else's message in one line: control characters and blanks at the end go.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// "1 light", "2 lights".
inline std::string counted(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

} // namespace lightcuts
