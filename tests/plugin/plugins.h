// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <lightcuts/oracle/plugin_subject.h>

namespace lightcuts::oracle {

/// A variant of faulty_tree.c, or half_bound.
inline std::filesystem::path plugin_file(const std::string& name) {
  return std::filesystem::path(LIGHTCUTS_PLUGINS) / ("lib" + name + ".so");
}

/// Hangs are told from work by 2 s, in these tests.
inline std::unique_ptr<Subject> plugin(const std::string& name, double time_limit = 2) {
  return plugin_subject(plugin_file(name), {.time_limit = time_limit, .host = {}});
}

inline std::unique_ptr<Subject> brute_tree() { return plugin_subject(LIGHTCUTS_BRUTE_TREE); }

} // namespace lightcuts::oracle
