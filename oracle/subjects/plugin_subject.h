// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

struct PluginConfig {
  double time_limit = 10; ///< seconds for each question; default 10
  /// Bytes of address space for each process of the plug-in; default 4 GiB. Beyond that it is
  /// refused memory. No limit where the host is built with a sanitizer, which takes more.
  std::uint64_t memory_limit = std::uint64_t{4} << 30;
  std::filesystem::path host; ///< lightcuts-subject-host; default: beside the program, or where it
                              ///< was built
};

/// A light tree from a shared library that exports what subject_abi.h says. It runs in processes of
/// its own, one for each tree: one that crashes, hangs or answers what cannot be read makes a
/// SubjectFailure, with the file's name and the function. Bounds, estimates and probabilities are
/// asked for many at a time and remembered for one point; bounds() asks anew. Throws InputError,
/// naming the file, where that is no such library.
[[nodiscard]] std::unique_ptr<Subject> plugin_subject(const std::filesystem::path& file,
                                                      const PluginConfig& config = {});

} // namespace lightcuts::oracle
