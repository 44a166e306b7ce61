// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <oracle/cli/subjects.h>

namespace lightcuts::cli {

void add_subject_options(CLI::App& command, SubjectOptions& options) {
  command
      .add_option(
          "--subject", options.subject,
          "whom to judge: lightcuts, locally-ordered (the same on trees of that builder), paper, "
          "stochastic-intensity, mutant:NAME, or the light tree in a shared library written after "
          "lightcuts/oracle/subject_abi.h, ./FILE.so")
      ->capture_default_str();
  command
      .add_option("--time-limit", options.time_limit,
                  "of each question to a plug-in, seconds; after that it counts as hung")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
}

} // namespace lightcuts::cli
