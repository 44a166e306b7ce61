// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

namespace lightcuts {

/// The whole file. Throws InputError where it is no regular file (a device or a pipe may never
/// end), or cannot be opened or read.
inline std::string read_file(const std::filesystem::path& file) {
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(file, error);
  if (!regular && std::filesystem::exists(file, error) &&
      !std::filesystem::is_directory(file, error))
    throw InputError(InputFault::unreadable_file,
                     fmt::format("{}: cannot open: a device or a pipe, not a file", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!regular || !in)
    throw InputError(InputFault::unreadable_file, fmt::format("{}: cannot open", file.string()));
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::string text(error ? 0 : size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  // What was added meanwhile; and files of /proc, whose size is said to be 0.
  if (in) text.append(std::istreambuf_iterator<char>(in), {});
  if (in.bad())
    throw InputError(InputFault::unreadable_file, fmt::format("{}: cannot read", file.string()));
  return text;
}

/// A text file as UTF-8, its mark of byte order left out. Throws InputError where read_file() does,
/// and for UTF-16 and UTF-32.
inline std::string read_text(const std::filesystem::path& file) {
  std::string text = read_file(file);
  const bool marked = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  // Without a mark every second byte of English is 0.
  const bool zeros = text.size() > 3 && (text[0] == 0 || text[1] == 0 || text[3] == 0) &&
                     (text[0] != 0 || text[1] != 0 || text[2] != 0);
  if (marked || zeros)
    throw InputError(InputFault::unsupported,
                     fmt::format("{}: is UTF-16 or UTF-32; save it as UTF-8", file.string()));
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
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
