// SPDX-License-Identifier: MIT
#include <oracle/cli/command_line.h>

#include <ostream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/version.h>
#include <oracle/cli/common.h>

namespace lightcuts::cli {

std::optional<int> read_command_line(int argc, const char* const* argv, Action& chosen,
                                     std::ostream& out, std::ostream& err) {
  CLI::App app("Checks that a light tree's error bounds hold, and what they cost.",
               "lightcuts-oracle");
  app.set_version_flag("--version", std::string("lightcuts-oracle ") + version);
  app.require_subcommand(1);
  app.footer("Exit code: 0 all holds, 1 a property is violated, 2 usage, 3 input, 4 internal "
             "error.\n'lightcuts-oracle COMMAND --help' lists a command's options.");
  add_check_command(app, chosen);
  add_report_command(app, chosen);
  add_render_command(app, chosen);
  add_mutants_command(app, chosen);
  add_info_command(app, chosen);
  add_scenes_command(app, chosen);
  add_stress_command(app, chosen);
  add_errors_command(app, chosen);
  add_replay_command(app, chosen);
  add_new_subject_command(app, chosen);
  // CLI11 says only that a command is missing.
  const auto is_named = [&](const CLI::App* command) { return command->check_name(argv[1]); };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_named).empty()) {
    err << fmt::format("unknown command '{}'\nRun with --help for more information.\n", argv[1]);
    return usage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error, out, err) == 0 ? all_holds : usage;
  }
  return std::nullopt;
}

} // namespace lightcuts::cli
