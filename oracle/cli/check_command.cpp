// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "common.h"
#include "counterexample_file.h"
#include "progress.h"
#include "property_table.h"
#include "subjects.h"
#include <lightcuts/oracle/check.h>
#include <lightcuts/oracle/scene_case.h>
#include <lightcuts/render/needs.h>
#include <lightcuts/tree_builder.h>

namespace lightcuts::cli {
namespace {

using oracle::CheckResult;

struct CheckOptions : CommonOptions, SubjectOptions {};

std::string table_of(const Scene& scene, const oracle::Subject& subject, const CheckResult& result,
                     const CutConfig& cut) {
  return fmt::format("{}: {} lights, {} triangles, threshold {:g} %\n{} (node, point) pairs at {} "
                     "points, {} rays ({} too close to call), {:.1f} s\n\n{}",
                     scene.name, scene.lights.size(), scene.mesh.triangles.size(),
                     100 * double(cut.threshold), result.pairs, result.points, result.rays,
                     result.undecided_rays, result.seconds, property_table(result.tally, subject));
}

std::string json_of(const CheckOptions& options, const oracle::Subject& subject,
                    const CheckResult& result, const CutConfig& cut,
                    const std::optional<CounterexampleFile>& file) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/check/1"},
                              {"scene", options.scene},
                              {"subject", full_name(options.subject)},
                              {"not_judged", oracle::names_without(subject.parts())},
                              {"seed", options.seed},
                              {"threshold", std::stod(fmt::format("{}", cut.threshold))},
                              {"points", result.points},
                              {"pairs", result.pairs},
                              {"rays", result.rays},
                              {"undecided_rays", result.undecided_rays}};
  json["properties"] = properties_json(result.tally);
  json["violations"] = result.tally.violations();
  json["wasteful"] = result.tally.wasteful();
  json["counterexample"] = nullptr;
  if (file) json["counterexample"] = file->json();
  json["seconds"] = result.seconds;
  return text_of(json);
}

/// What is to be said of the counterexample, where something is broken.
std::string counterexample_text(const CheckResult& result,
                                const std::optional<CounterexampleFile>& file) {
  if (file) return file->text();
  const auto properties = oracle::broken(result.tally);
  if (properties.empty()) return {};
  return fmt::format("\nNo file for {}: it shows on this scene's geometry and materials only, not "
                     "in lights and\none point; the same command finds it again.\n",
                     info(properties.front()).name);
}

CheckResult checked(const CheckOptions& options, const SceneView& view,
                    const oracle::Subject& subject, oracle::CheckConfig config) {
  Progress progress("check " + options.scene);
  config.progress = progress.callback();
  return check(view, subject, config);
}

int run(const CheckOptions& options) {
  const std::unique_ptr<oracle::Subject> subject = subject_for(options);
  JsonFolder folder(options);
  const Scene scene = open_lit_scene_for(options);
  const SceneView view(scene);
  oracle::CheckConfig config = check_config_for(options, view);
  config.cut.black_level =
      find_needs(view, build(scene.lights, {options.seed}), config.cut).black_level;
  const CheckResult result = checked(options, view, *subject, config);
  std::optional<CounterexampleFile> file;
  if (const auto found = counterexample_of(*subject, view, config, result))
    file.emplace(*subject, full_name(options.subject), *found, output_folder_for(options));
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
  options->scene = "desk";
  CLI::App* command = app.add_subcommand("check", "Check every property on a scene.");
  add_common_options(*command, *options);
  add_threshold_option(*command, *options);
  add_json_folder_option(*command, *options);
  add_cases_option(*command, *options);
  add_subject_options(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
