// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <oracle/cli/subjects.h>
#include <oracle/options/count.h>
#include <oracle/options/values.h>

namespace lightcuts::cli {

void add_subject_options(CLI::App& command, SubjectOptions& options) {
  command
      .add_option("--subject", options.subject,
                  "whom to judge: lightcuts, locally-ordered (the same on trees of that builder), "
                  "block-cuts, "
                  "paper, stochastic-intensity, mutant:NAME, or the light tree in a shared library "
                  "written after "
                  "lightcuts/oracle/subject_abi.h, ./FILE.so")
      ->capture_default_str();
  add_plugin_options(command, options.plugin);
}

void add_plugin_options(CLI::App& command, oracle::PluginConfig& config) {
  command
      .add_option("--time-limit", config.time_limit,
                  "of each question to a plug-in, seconds; after that it counts as hung, "
                  "unless the machine kept it from running")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--memory-limit",
          [&config](const std::string& text) {
            config.memory_limit = *options::parse_memory(text);
          },
          "of each process of a plug-in, such as 512MiB or 4GiB; beyond that it is refused memory")
      ->check(options::check_memory)
      ->default_str("4GiB");
}

} // namespace lightcuts::cli
