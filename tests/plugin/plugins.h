// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <oracle/subjects/plugin_subject.h>

namespace lightcuts::oracle {

/// A variant of faulty_tree.c, or half_bound.
inline std::filesystem::path plugin_file(const std::string& name) {
  return std::filesystem::path(LIGHTCUTS_PLUGINS) / ("lib" + name + ".so");
}

/// Seconds to wait for the plug-in: those that answer may take their time on a busy machine; 1 s
/// tells those that do not.
inline double patience(const std::string& name) {
  for (const char* silent : {"hang", "closes", "forks"})
    if (name.starts_with(silent)) return 1;
  return 60;
}

inline std::unique_ptr<Subject> plugin(const std::string& name) {
  return plugin_subject(plugin_file(name), {.time_limit = patience(name), .host = {}});
}

/// The library of oracle/example/NAME.c.
inline std::unique_ptr<Subject> example(const std::string& name) {
  return plugin_subject(std::filesystem::path(LIGHTCUTS_EXAMPLES) / ("lib" + name + ".so"),
                        {.time_limit = 60, .host = {}});
}

inline std::unique_ptr<Subject> brute_tree() { return plugin_subject(LIGHTCUTS_BRUTE_TREE); }

} // namespace lightcuts::oracle
