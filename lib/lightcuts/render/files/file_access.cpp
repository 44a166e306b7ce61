// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/file_access.h>

#include <algorithm>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

/// Absolute, links followed as far as the file exists; empty where that fails.
std::filesystem::path without_links(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path found = std::filesystem::absolute(file, error);
  if (!error) found = std::filesystem::weakly_canonical(found, error);
  return error ? std::filesystem::path() : found;
}

} // namespace

FileAccess::FileAccess(const std::filesystem::path& scene, bool allow_outside)
    : folder_(without_links(scene.has_parent_path() ? scene.parent_path() : ".")),
      allow_outside_(allow_outside) {}

bool FileAccess::allows(const std::filesystem::path& file) const {
  if (allow_outside_) return true;
  const std::filesystem::path found = without_links(file);
  // A name that ends in a slash ends in an empty part.
  const auto end = folder_.end() == folder_.begin() || !std::prev(folder_.end())->empty()
                       ? folder_.end()
                       : std::prev(folder_.end());
  return !found.empty() &&
         std::mismatch(folder_.begin(), end, found.begin(), found.end()).first == end;
}

void FileAccess::require(const std::filesystem::path& file, const std::string& name) const {
  if (!allows(file))
    throw InputError(InputFault::unreadable_file,
                     one_line(fmt::format("{}: lies outside the scene's folder; "
                                          "--allow-outside allows it",
                                          name)));
}

} // namespace lightcuts
