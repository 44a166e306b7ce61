// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

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

/// Processes that the process has started.
inline std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> all;
  std::error_code gone;
  const std::filesystem::path tasks = "/proc/" + std::to_string(parent) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks, gone)) {
    std::ifstream file(task.path() / "children");
    for (pid_t child = 0; file >> child;) all.push_back(child);
  }
  return all;
}

/// The first child of a process, once it has one.
inline pid_t child_of(pid_t parent) {
  for (int i = 0; i < 1000; ++i) {
    if (const auto children = children_of(parent); !children.empty()) return children.front();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return 0;
}

/// A child of the process that has one itself, and that one, once there are such.
inline std::pair<pid_t, pid_t> child_and_grandchild_of(pid_t parent) {
  for (int i = 0; i < 1000; ++i) {
    for (const pid_t child : children_of(parent))
      if (const auto grandchildren = children_of(child); !grandchildren.empty())
        return {child, grandchildren.front()};
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {0, 0};
}

inline bool is_running(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string id, name, state;
  return file >> id >> name >> state && state != "Z"; // nobody may have waited for it
}

/// Whether the process ends within 5 s.
inline bool ends(pid_t process) {
  for (int i = 0; i < 500 && is_running(process); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !is_running(process);
}

} // namespace lightcuts::oracle
