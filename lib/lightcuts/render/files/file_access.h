// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace lightcuts {

/// Which files a scene may name: those in the folder of the file that was opened, and below it. A
/// scene from somewhere else cannot make a program read what it has no business with.
class FileAccess {
public:
  /// For the scene file that was opened. allow_outside: any file may be read; default: false.
  explicit FileAccess(const std::filesystem::path& scene, bool allow_outside = false);

  /// Throws InputError unless `file`, links followed, lies in the folder or below. The message
  /// begins with the file's name as given by `name`.
  void require(const std::filesystem::path& file, const std::string& name) const;

  /// Whether require() lets it pass.
  [[nodiscard]] bool allows(const std::filesystem::path& file) const;

private:
  std::filesystem::path folder_; ///< without links
  bool allow_outside_;
};

} // namespace lightcuts
