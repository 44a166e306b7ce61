// SPDX-License-Identifier: MIT
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "common.h"
#include "progress.h"
#include <lightcuts/oracle/check.h>
#include <lightcuts/render/needs.h>
#include <lightcuts/tree_builder.h>

namespace lightcuts::cli {
namespace {

using oracle::CheckResult;
using oracle::Property;
using oracle::PropertyCount;

std::string ratio_text(double ratio) {
  if (ratio < 0) return "-";
  if (ratio > 1e6) return "> 10^6";
  return ratio != 0 && ratio < 1e-4 ? fmt::format("{:.1e}", ratio) : fmt::format("{:.4f}", ratio);
}

std::string table_of(const Scene& scene, const oracle::Subject& subject, const CheckResult& result,
                     const CutConfig& cut) {
  std::string text = fmt::format(
      "{}: {} lights, {} triangles, threshold {:g} %\n{} (node, point) pairs at {} points, {} "
      "rays ({} too close to call), {:.1f} s\n\n{:<31}{:>12}{:>12}{:>13}\n",
      scene.name, scene.lights.size(), scene.mesh.triangles.size(), 100 * double(cut.threshold),
      result.pairs, result.points, result.rays, result.undecided_rays, result.seconds, "property",
      "cases", "violations", "worst ratio");
  for (std::size_t i = 0; i < oracle::property_count; ++i) {
    const PropertyCount& count = result.tally[Property(i)];
    text += fmt::format("{:<31}{:>12}{:>12}{:>13}\n", info(Property(i)).name, count.cases,
                        count.violations, ratio_text(count.worst_ratio));
    if (count.violations > 0) text += fmt::format("  first: {}\n", count.first_violation);
  }
  if (const std::string absent = not_judged(subject); !absent.empty()) text += "\n" + absent;
  text += result.tally.violations() == 0
              ? "\nAll properties hold.\n"
              : fmt::format("\n{} violations.\n", result.tally.violations());
  return text;
}

std::string json_of(const CommonOptions& options, const oracle::Subject& subject,
                    const CheckResult& result, const CutConfig& cut) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/check/1"},
                              {"scene", options.scene},
                              {"subject", subject.name()},
                              {"not_judged", oracle::names_without(subject.parts())},
                              {"seed", options.seed},
                              {"threshold", std::stod(fmt::format("{}", cut.threshold))},
                              {"points", result.points},
                              {"pairs", result.pairs},
                              {"rays", result.rays},
                              {"undecided_rays", result.undecided_rays}};
  auto& properties = json["properties"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < oracle::property_count; ++i) {
    const PropertyCount& count = result.tally[Property(i)];
    nlohmann::ordered_json entry{
        {"name", info(Property(i)).name}, {"cases", count.cases}, {"violations", count.violations}};
    entry["worst_ratio"] = nullptr; // where the property is a matter of yes or no
    if (count.worst_ratio >= 0) entry["worst_ratio"] = count.worst_ratio;
    if (count.violations > 0) entry["first_violation"] = count.first_violation;
    properties.push_back(entry);
  }
  json["violations"] = result.tally.violations();
  json["seconds"] = result.seconds;
  return text_of(json);
}

int run(const CommonOptions& options) {
  JsonFolder folder(options);
  const std::unique_ptr<oracle::Subject> subject = subject_for(options);
  const Scene scene = open_lit_scene_for(options);
  const SceneView view(scene);
  const LightTree tree = build(scene.lights, {options.seed});
  oracle::CheckConfig config = check_config_for(options, view);
  config.cut.black_level = find_needs(view, tree, config.cut).black_level;
  CheckResult result;
  {
    Progress progress("check " + options.scene);
    config.progress = progress.callback();
    result = check(view, *subject, config);
  }
  const std::string json = json_of(options, *subject, result, config.cut);
  folder.write("check.json", json);
  print_results(options, table_of(scene, *subject, result, config.cut), json);
  return result.tally.violations() == 0 ? all_holds : violated;
}

} // namespace

void add_check_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CommonOptions>();
  options->scene = "desk";
  CLI::App* command = app.add_subcommand("check", "Check every property on a scene.");
  add_common_options(*command, *options);
  add_threshold_option(*command, *options);
  add_json_folder_option(*command, *options);
  add_cases_option(*command, *options);
  add_subject_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
