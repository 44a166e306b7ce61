// SPDX-License-Identifier: MIT
#include <csignal>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/numerics/splitmix.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/campaign/check.h>
#include <oracle/campaign/scene_case.h>
#include <oracle/cli/campaign_file.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/counterexample_file.h>
#include <oracle/cli/progress_line.h>
#include <oracle/cli/property_table.h>
#include <oracle/cli/subjects.h>
#include <oracle/numbers/same_digits.h>
#include <oracle/options/count.h>
#include <oracle/options/scene_options.h>
#include <oracle/records/record_json.h>

namespace lightcuts::cli {
namespace {

using oracle::CheckResult;

struct CheckOptions : CommonOptions, SubjectOptions {
  std::string time, resume;
};

/// Set by Ctrl-C: the check ends, and tells what it has found. A second one ends the process.
volatile std::sig_atomic_t interrupted = 0;

/// Ctrl-C sets `interrupted` while this lives.
class InterruptGuard {
public:
  InterruptGuard() {
    std::signal(SIGINT, [](int) {
      interrupted = 1;
      std::signal(SIGINT, SIG_DFL);
    });
  }
  ~InterruptGuard() { std::signal(SIGINT, SIG_DFL); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// How fast bounds were checked where they were swept.
double sweep_rate(const CheckResult& result) {
  return result.sweep_seconds > 0 ? double(result.swept_pairs) / result.sweep_seconds : 0;
}

std::string sweep_text(const CheckResult& result) {
  if (result.swept_pairs == 0) return {};
  return fmt::format("\n{} of the pairs were swept, bounds alone: {:.1f} million per second and "
                     "thread.\n",
                     result.swept_pairs, 1e-6 * sweep_rate(result));
}

std::string table_of(const Scene& scene, const oracle::Subject& subject, const CheckResult& result,
                     const CutConfig& cut) {
  return fmt::format("{}: {} lights, {} triangles, threshold {:g} %\n{} (node, point) pairs at {} "
                     "points, {} rays ({} too close to call), {:.1f} s\n\n{}",
                     scene.name, scene.lights.size(), scene.mesh.triangles.size(),
                     100 * double(cut.threshold), result.pairs, result.points, result.rays,
                     result.undecided_rays, result.seconds, property_table(result.tally, subject)) +
         sweep_text(result) + (result.complete ? "" : "\nStopped before all cases were done.\n");
}

std::string json_of(const CheckOptions& options, const oracle::Subject& subject,
                    const CheckResult& result, const CutConfig& cut,
                    const std::optional<CounterexampleFile>& file) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/check/1"},
                              {"scene", options.open.spec},
                              {"subject", oracle::full_subject_name(options.subject)},
                              {"not_judged", oracle::names_without(subject.parts())},
                              {"seed", options.seed},
                              {"threshold", oracle::same_digits(cut.threshold)},
                              {"points", result.points},
                              {"pairs", result.pairs},
                              {"rays", result.rays},
                              {"undecided_rays", result.undecided_rays}};
  json["properties"] = properties_json(result.tally);
  json["violations"] = result.tally.violations();
  json["wasteful"] = result.tally.wasteful();
  json["counterexample"] = nullptr;
  if (file) json["counterexample"] = file->json();
  json["complete"] = result.complete;
  json["swept_pairs"] = result.swept_pairs;
  json["swept_pairs_per_second"] = sweep_rate(result);
  json["seconds"] = result.seconds;
  return text_of(json);
}

/// What is to be said of the counterexample, where something is broken.
std::string counterexample_text(const CheckResult& result,
                                const std::optional<CounterexampleFile>& file) {
  if (file) return file->text();
  const auto properties = oracle::broken(result.tally);
  if (properties.empty()) return {};
  if (properties.front() == oracle::Property::subject_answers)
    return fmt::format(
        "\nNo file for {}, as it is on the scene's lights taken together:\n  {}\nThe "
        "same command finds it again.\n",
        info(properties.front()).name, result.tally[properties.front()].first_violation);
  return fmt::format("\nNo file for {}: it shows on this scene's geometry and materials only, not "
                     "in lights and\none point; the same command finds it again.\n",
                     info(properties.front()).name);
}

/// A hash of all lights, whatever made them.
std::uint64_t fingerprint(const LightSet& lights) {
  std::uint64_t hash = oracle::fingerprint(lights.min_distance());
  for (const Light& light : lights) hash = splitmix64(hash ^ oracle::fingerprint(light));
  return hash;
}

/// What the counts depend on.
nlohmann::ordered_json campaign_of(const CheckOptions& options, const Scene& scene,
                                   const oracle::CheckConfig& config) {
  return {{"scene", options.open.spec},
          {"subject", oracle::full_subject_name(options.subject)},
          {"seed", options.seed},
          {"lights", scene.lights.size()},
          {"hash of the lights", fingerprint(scene.lights)},
          {"triangles", scene.mesh.triangles.size()},
          {"width", scene.image_size.x},
          {"height", scene.image_size.y},
          {"cut", oracle::json_of(config.cut)}};
}

CheckResult checked(const CheckOptions& options, const SceneView& view,
                    const oracle::Subject& subject, oracle::CheckConfig config) {
  std::optional<CampaignFile> campaign;
  CheckResult before;
  if (!options.resume.empty()) {
    campaign.emplace(options.resume, campaign_of(options, view.scene(), config));
    before = campaign->load();
    config.checkpoint = [&](const CheckResult& so_far) { campaign->save(so_far); };
    if (before.points == 0) campaign->save(before); // refused now, not after the long job
  }
  if (!options.time.empty()) config.seconds = *options::parse_duration(options.time);
  const InterruptGuard guard;
  ProgressLine line("check " + options.open.spec);
  config.progress = line.progress([] { return interrupted != 0; });
  const CheckResult result = check(view, subject, config, before);
  if (campaign) campaign->save(result);
  return result;
}

int run(const CheckOptions& options) {
  const std::unique_ptr<oracle::Subject> subject = subject_for(options);
  JsonFolder folder(options);
  const Scene scene = open_lit_scene_for(options);
  const SceneView view(scene);
  oracle::CheckConfig config = check_config_for(options, view);
  config.cut.black_level =
      find_scene_features(view, build(scene.lights, {options.seed}), config.cut).black_level;
  const CheckResult result = checked(options, view, *subject, config);
  std::optional<CounterexampleFile> file;
  if (const auto found = counterexample_of(*subject, view, config, result))
    file.emplace(*subject, oracle::full_subject_name(options.subject), *found,
                 output_folder_for(options));
  const std::string json = json_of(options, *subject, result, config.cut, file);
  folder.write("check.json", json);
  print_results(options,
                table_of(scene, *subject, result, config.cut) + counterexample_text(result, file),
                json);
  return exit_code_for(result.tally, *subject);
}

} // namespace

void add_check_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CheckOptions>();
  options->open.spec = "desk";
  CLI::App* command = app.add_subcommand("check", "Check every property on a scene.");
  add_common_options(*command, *options);
  options::add_threshold_option(*command, options->threshold);
  command->add_option("--out", options->out,
                      "folder for check.json and for what fails, counterexample-PROPERTY.json; "
                      "default: no check.json, counterexamples to out/SCENE");
  add_cases_option(*command, *options);
  add_subject_options(*command, *options);
  command
      ->add_option("--time", options->time,
                   "end after so long, such as 90s, 10m or 2h; default: when all cases are done")
      ->check([](const std::string& text) {
        return options::parse_duration(text)
                   ? ""
                   : "'" + text + "' is not a time such as 90s, 10m or 2h";
      });
  command->add_option("--resume", options->resume,
                      "file that keeps the counts: goes on from what it has; Ctrl-C saves, too");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
