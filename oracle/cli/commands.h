// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace CLI {
class App;
} // namespace CLI

namespace lightcuts::cli {

struct CommonOptions;
struct SubjectOptions;

/// A subcommand's work, run once the command line has been read; returns an Exit.
using Action = std::function<int()>;

// Each adds its subcommand with all options; `chosen` becomes its work when it is given.
void add_check_command(CLI::App& app, Action& chosen);
void add_errors_command(CLI::App& app, Action& chosen);
void add_info_command(CLI::App& app, Action& chosen);
void add_mutants_command(CLI::App& app, Action& chosen);
void add_new_subject_command(CLI::App& app, Action& chosen);
void add_render_command(CLI::App& app, Action& chosen);
void add_replay_command(CLI::App& app, Action& chosen);
void add_report_command(CLI::App& app, Action& chosen);
void add_scenes_command(CLI::App& app, Action& chosen);
void add_stress_command(CLI::App& app, Action& chosen);

/// The work of 'stress --catalogue': judges the subject on all named cases and prints what came of
/// each. Returns an Exit.
[[nodiscard]] int run_catalogue(const CommonOptions& options, const SubjectOptions& judged);

} // namespace lightcuts::cli
