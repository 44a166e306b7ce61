// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/scene.h>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {

/// A folder of this process alone, gone when it ends.
class WorkFolder {
public:
  /// With what tests/files/NAME holds, so that inputs can name files that are there.
  explicit WorkFolder(const std::string& like = {});
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// Writes the file; returns its path.
  std::filesystem::path put(const std::string& name, std::string_view content) const;
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return path_ / name; }
  /// Of the folder itself.
  [[nodiscard]] std::string name() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

/// A message for people: one line, not empty, without control characters, and naming `name`; else
/// a finding().
void require_message(const std::string& message, const std::string& name);

/// What reads a file returns, or throws an InputError that names it.
template <class Read>
void read_or_refused(const std::string& name, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    require_message(error.what(), name);
  }
}

/// A scene that was read is valid, and its notes are messages; else a finding().
void require_valid(const Scene& scene);

/// The pixel in the middle of the picture can be lit; else a finding(). Takes milliseconds.
void require_lit(const Scene& scene);

} // namespace lightcuts::fuzz
