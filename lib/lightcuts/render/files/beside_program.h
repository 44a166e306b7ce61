// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <system_error>

namespace lightcuts {

/// The file of the same name in the folder of the program that runs, where there is one: programs
/// may be moved together with what they need. Else `built`, where the build put it.
inline std::filesystem::path beside_program(const std::filesystem::path& built) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::filesystem::path beside = program.parent_path() / built.filename();
  return std::filesystem::exists(beside, error) ? beside : built;
}

} // namespace lightcuts
