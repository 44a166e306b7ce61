// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <oracle/counterexamples/named_subjects.h>

namespace CLI {
class App;
} // namespace CLI

namespace lightcuts::cli {

/// Whom to judge.
struct SubjectOptions {
  std::string subject = "lightcuts";
  oracle::PluginConfig plugin;
};

/// Adds --subject, --time-limit and --memory-limit.
void add_subject_options(CLI::App& command, SubjectOptions& options);
/// Adds --time-limit and --memory-limit.
void add_plugin_options(CLI::App& command, oracle::PluginConfig& config);

[[nodiscard]] inline std::unique_ptr<oracle::Subject> subject_for(const SubjectOptions& options) {
  return oracle::subject_named(options.subject, options.plugin);
}

} // namespace lightcuts::cli
