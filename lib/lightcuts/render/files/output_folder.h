// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lightcuts {

/// A folder of results that appears whole or not at all. Files are written to a hidden temporary
/// folder; commit() moves them to the final one. What was not committed is removed with the object,
/// so that a failed run leaves nothing behind and overwrites nothing.
class OutputFolder {
public:
  /// Makes the temporary folder (with missing parents): inside `final_folder` where that exists,
  /// beside it otherwise. Throws InputError, naming the folder, where it cannot be written: known
  /// before the long job, not after.
  explicit OutputFolder(const std::filesystem::path& final_folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write the file that will be `name` in the final folder. name: a file name without
  /// folders; anything else throws InputError. The same name again gives the same path.
  [[nodiscard]] std::filesystem::path stage(const std::string& name);

  /// Moves every staged file to the final folder, replacing files of the same name one by one,
  /// each atomically; other files there are left alone. Throws InputError, having moved nothing,
  /// where a staged file was not written or a folder has its name. Call it once, last.
  void commit();

private:
  std::filesystem::path final_, temporary_;
  std::vector<std::filesystem::path> made_; // missing parents, outermost first
  std::vector<std::string> names_;
};

/// Writes `content` to `file` so that a reader finds the old file or the new one, never a part:
/// into a temporary file beside it, then renamed. Follows symbolic links; devices and pipes
/// (/dev/stdout) are written directly. Throws InputError, naming the file.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// Throws InputError, naming the file, where write_file_atomically() could not write it: known
/// before the long job, not after.
void require_writable(const std::filesystem::path& file);

} // namespace lightcuts
