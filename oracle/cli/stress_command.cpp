// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <oracle/campaign/hunt.h>
#include <oracle/cases/random_case.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/counterexample_file.h>
#include <oracle/cli/progress_line.h>
#include <oracle/cli/property_table.h>
#include <oracle/cli/subjects.h>
#include <oracle/options/count.h>
#include <oracle/options/values.h>

namespace lightcuts::cli {
namespace {

struct StressOptions : CommonOptions, SubjectOptions {
  bool catalogue = false; ///< the named cases in place of random ones
};

oracle::HuntResult hunted(const StressOptions& options, const oracle::Subject& subject) {
  oracle::HuntConfig config;
  config.seed = options.seed;
  config.cases = *options::parse_count(options.cases);
  config.waste = oracle::is_library(subject);
  config.further = 200;
  config.threads = options.threads;
  ProgressLine line("stress " + options.subject);
  config.progress = line.progress();
  return hunt(subject, config);
}

/// What was found; else the first waste, for which nobody but the library was stopped.
std::optional<oracle::Counterexample> counterexample_of(const oracle::HuntResult& result,
                                                        std::uint64_t seed) {
  if (result.found) return result.found;
  const auto properties = oracle::broken(result.tally);
  if (properties.empty()) return std::nullopt;
  const oracle::PropertyCount& count = result.tally[properties.front()];
  return oracle::Counterexample{properties.front(), oracle::random_case(seed, count.first_place),
                                count.first_violation, count.first_place};
}

std::string stress_command(const StressOptions& options, std::uint64_t cases) {
  return fmt::format("lightcuts-oracle stress --subject {} --seed {} --cases {}",
                     quoted(oracle::full_subject_name(options.subject)), options.seed, cases);
}

std::string table_of(const StressOptions& options, const oracle::Subject& subject,
                     const oracle::HuntResult& result,
                     const std::optional<CounterexampleFile>& file) {
  std::string text =
      fmt::format("{}: {} random cases of seed {}, up to {} lights, {:.1f} s\n\n{}",
                  oracle::full_subject_name(options.subject), result.cases, options.seed,
                  result.most_lights, result.seconds, property_table(result.tally, subject));
  if (file)
    text +=
        file->text() + fmt::format("find it again:\n  {}\n", stress_command(options, result.cases));
  return text;
}

std::string json_of(const StressOptions& options, const oracle::Subject& subject,
                    const oracle::HuntResult& result,
                    const std::optional<CounterexampleFile>& file) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/stress/1"},
                              {"subject", oracle::full_subject_name(options.subject)},
                              {"not_judged", oracle::names_without(subject.parts())},
                              {"seed", options.seed},
                              {"cases", result.cases},
                              {"most_lights", result.most_lights}};
  json["properties"] = properties_json(result.tally);
  json["violations"] = result.tally.violations();
  json["wasteful"] = result.tally.wasteful();
  json["counterexample"] = nullptr;
  if (file) json["counterexample"] = file->json();
  json["seconds"] = result.seconds;
  return text_of(json);
}

int run(const StressOptions& options) {
  if (options.catalogue) return run_catalogue(options, options);
  require_writable_json(options);
  const std::unique_ptr<oracle::Subject> subject = subject_for(options);
  const oracle::HuntResult result = hunted(options, *subject);
  std::optional<CounterexampleFile> file;
  if (const auto found = counterexample_of(result, options.seed))
    file.emplace(*subject, oracle::full_subject_name(options.subject), *found, options.out);
  print_results(options, table_of(options, *subject, result, file),
                json_of(options, *subject, result, file));
  return exit_code_for(result.tally, *subject);
}

} // namespace

void add_stress_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<StressOptions>();
  options->cases = "10000";
  options->threads = 1;
  options->out = "out/stress";
  CLI::App* command = app.add_subcommand(
      "stress", "Check every property on random cases of what this field finds hard, until one "
                "does not hold; that one is shrunk and saved.");
  command->add_option("--cases", options->cases, "random cases at most, such as 1000000 or 1e6")
      ->check(options::check_count)
      ->capture_default_str();
  add_threads_option(*command, *options);
  command
      ->add_flag("--catalogue", options->catalogue,
                 "named cases, each of which is known to be hard, in place of random ones")
      ->excludes("--cases")
      ->excludes("--threads");
  add_seed_option(*command, *options);
  add_subject_options(*command, *options);
  command->add_option("--out", options->out, "folder for counterexample-PROPERTY.json")
      ->capture_default_str();
  add_json_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
