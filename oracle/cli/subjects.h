// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <lightcuts/oracle/subject.h>

namespace lightcuts::cli {

/// Whom to judge.
struct SubjectOptions {
  std::string subject = "lightcuts";
  double time_limit = 10; ///< of each question to a plug-in, seconds
};

/// Adds --subject and --time-limit.
void add_subject_options(CLI::App& command, SubjectOptions& options);

/// "lightcuts", "paper", "stochastic-intensity", "mutant:NAME", a mutant's mere name, or the file
/// of a plug-in: what has a slash or ends in ".so". Throws InputError, naming it, where there is no
/// such subject.
[[nodiscard]] std::unique_ptr<oracle::Subject> subject_for(const SubjectOptions& options);

/// The name in full by which files remember a subject: a mutant's gets its "mutant:".
[[nodiscard]] std::string full_name(const std::string& name);

/// Whether it is the library, of which waste is a failure, too.
[[nodiscard]] bool is_library(const oracle::Subject& subject);

} // namespace lightcuts::cli
