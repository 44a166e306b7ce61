// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/input_error.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/subjects.h>
#include <oracle/counterexamples/as_test.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/explain/explain.h>

namespace lightcuts::cli {
namespace {

struct ReplayOptions : CommonOptions {
  std::string file, subject;
  oracle::PluginConfig plugin;
  bool as_test = false;
};

/// Names of the properties that do not hold on the case but for `but`.
std::vector<std::string> others_broken(const oracle::Tally& tally, oracle::Property but) {
  std::vector<std::string> names;
  for (const oracle::Property property : oracle::broken(tally))
    if (property != but) names.emplace_back(info(property).name);
  return names;
}

std::string json_of(const ReplayOptions& options, const oracle::SavedCounterexample& saved,
                    const oracle::Tally& tally) {
  const oracle::PropertyCount& count = tally[saved.counterexample.property];
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/replay/1"},
                              {"file", options.file},
                              {"subject", saved.subject},
                              {"property", info(saved.counterexample.property).name},
                              {"fails", count.violations > 0},
                              {"message", count.first_violation}};
  json["also_broken"] = others_broken(tally, saved.counterexample.property);
  return text_of(json);
}

std::string text_for(const oracle::Subject& subject, const oracle::SavedCounterexample& saved,
                     const oracle::Tally& tally) {
  const oracle::Counterexample& c = saved.counterexample;
  std::string text = explain(subject, c);
  const auto others = others_broken(tally, c.property);
  if (!others.empty()) text += fmt::format("\nalso broken: {}\n", fmt::join(others, ", "));
  return text + fmt::format("\n{} {} {} on this case.\n", info(c.property).name,
                            tally[c.property].violations > 0 ? "is still violated by" : "holds for",
                            subject.name());
}

/// Throws InputError, naming the counterexample's file where that has the name of the subject.
std::unique_ptr<oracle::Subject> subject_of(const ReplayOptions& options, const std::string& name) {
  try {
    return oracle::subject_named(name, options.plugin);
  } catch (const InputError& e) {
    if (!options.subject.empty()) throw;
    throw InputError(e.fault(), fmt::format("{}: its subject cannot be judged: {}; --subject names "
                                            "another",
                                            options.file, e.what()));
  }
}

int run(const ReplayOptions& options) {
  require_writable_json(options);
  oracle::SavedCounterexample saved = oracle::load_counterexample(options.file);
  if (!options.subject.empty()) saved.subject = oracle::full_subject_name(options.subject);
  if (options.as_test) {
    fmt::print("{}", oracle::as_test(saved));
    return all_holds;
  }
  const std::unique_ptr<oracle::Subject> subject = subject_of(options, saved.subject);
  oracle::Tally tally;
  check_case(*subject, saved.counterexample.on, 0, tally);
  print_results(options, text_for(*subject, saved, tally), json_of(options, saved, tally));
  return tally[saved.counterexample.property].violations > 0 ? violated : all_holds;
}

} // namespace

void add_replay_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(
      "replay", "Judge a saved counterexample again, and show the arithmetic step by step (exit "
                "code 1 while the property does not hold).");
  command
      ->add_option("FILE", options->file,
                   "a counterexample-NAME.json of 'check', 'stress' or 'mutants'")
      ->required();
  command->add_option("--subject", options->subject,
                      "whom to judge, as check and stress have it; default: the file's");
  add_plugin_options(*command, options->plugin);
  command->add_flag("--as-test", options->as_test,
                    "print a GoogleTest case to paste instead, and judge nothing");
  add_json_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
