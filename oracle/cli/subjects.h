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
  double time_limit = 10; ///< of each question to a plug-in, seconds
};

/// Adds --subject and --time-limit.
void add_subject_options(CLI::App& command, SubjectOptions& options);

[[nodiscard]] inline std::unique_ptr<oracle::Subject> subject_for(const SubjectOptions& options) {
  return oracle::subject_named(options.subject, options.time_limit);
}

} // namespace lightcuts::cli
