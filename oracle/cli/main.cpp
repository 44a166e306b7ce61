// SPDX-License-Identifier: MIT
// lightcuts-oracle: checks, measures and renders many-light scenes.
#include <cstdio>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/version.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>

namespace {

using namespace lightcuts;

int run(int argc, char** argv) {
  CLI::App app("Checks that a light tree's error bounds hold, and what they cost.",
               "lightcuts-oracle");
  app.set_version_flag("--version", std::string("lightcuts-oracle ") + version);
  app.require_subcommand(1);
  app.footer("Exit code: 0 all holds, 1 a property is violated, 2 usage, 3 input, 4 internal "
             "error.\n'lightcuts-oracle COMMAND --help' lists a command's options.");
  cli::Action chosen;
  cli::add_check_command(app, chosen);
  cli::add_report_command(app, chosen);
  cli::add_render_command(app, chosen);
  cli::add_mutants_command(app, chosen);
  cli::add_info_command(app, chosen);
  cli::add_scenes_command(app, chosen);
  cli::add_stress_command(app, chosen);
  cli::add_errors_command(app, chosen);
  cli::add_replay_command(app, chosen);
  cli::add_new_subject_command(app, chosen);
  // CLI11 says only that a command is missing.
  const auto is_named = [&](const CLI::App* command) { return command->check_name(argv[1]); };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_named).empty()) {
    fmt::print(stderr, "unknown command '{}'\nRun with --help for more information.\n", argv[1]);
    return cli::usage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? cli::all_holds : cli::usage;
  }
  const int result = chosen();
  if (std::fflush(stdout) != 0)
    throw InputError(InputFault::unwritable_file, "stdout: cannot be written");
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const lightcuts::InputError& e) {
    fmt::print(stderr, "lightcuts-oracle: {}\n", e.what());
    return cli::bad_input;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "lightcuts-oracle: out of memory\n");
    return cli::internal_error;
  } catch (const std::exception& e) {
    fmt::print(stderr, "lightcuts-oracle: internal error: {}\n", e.what());
    return cli::internal_error;
  }
}
