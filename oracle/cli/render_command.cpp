// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/view/method_choice.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/progress_line.h>
#include <oracle/numbers/same_digits.h>
#include <oracle/options/scene_options.h>
#include <oracle/report/light_groups.h>
#include <oracle/report/plots/pictures.h>

namespace lightcuts::cli {
namespace {

constexpr const char* any_method = "auto";

struct RenderOptions : CommonOptions {
  std::string method = any_method;
  bool groups = false;
};

double mean(const std::vector<float>& values, std::uint64_t count) {
  double sum = 0;
  for (const float v : values) sum += v;
  return count == 0 ? 0 : sum / double(count);
}

/// Sums over the pixels of all groups.
struct GroupTotals {
  double light = 0, certified = 0;

  explicit GroupTotals(const std::vector<oracle::GroupPicture>& groups) {
    for (const oracle::GroupPicture& group : groups) {
      light += group.light();
      certified += group.certified_error();
    }
  }
};

double share_of(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// A line for each group: how much of the light it makes, and of what the certified error is.
std::string table_of(const std::vector<oracle::GroupPicture>& groups) {
  const GroupTotals totals(groups);
  std::string text;
  for (const oracle::GroupPicture& group : groups)
    text += fmt::format(
        "group {}: {}, {:.2f} % of the light and {:.2f} % of the certified error, {:.2f} s\n",
        group.name, counted(group.lights, "light"), 100 * share_of(group.light(), totals.light),
        100 * share_of(group.certified_error(), totals.certified), group.rendering.seconds);
  return text;
}

nlohmann::ordered_json json_of(const std::vector<oracle::GroupPicture>& groups) {
  const GroupTotals totals(groups);
  auto list = nlohmann::ordered_json::array();
  for (const oracle::GroupPicture& group : groups)
    list.push_back(
        {{"name", group.name},
         {"lights", group.lights},
         {"share_of_light", share_of(group.light(), totals.light)},
         {"share_of_certified_error", share_of(group.certified_error(), totals.certified)},
         {"seconds", group.rendering.seconds}});
  return list;
}

int run(const RenderOptions& options) {
  const Scene scene = open_lit_scene_for(options);
  if (options.groups && scene.groups.empty())
    throw InputError(InputFault::missing, scene.name + ": no light has a group");
  const std::filesystem::path out = output_folder_for(options);
  OutputFolder folder(out);
  (void)image_codec(); // refused before the long job where it cannot be loaded
  const SceneView view(scene);
  const LightTree tree = build(scene.lights, build_config_for(options));
  RenderConfig config;
  if (options.method != any_method) config.method = *method_named(options.method);
  config.cut = {threshold_for(options, view), options.max_cut, 0};
  config.threads = options.threads;
  config.seed = options.seed;
  const SceneFeatures features = find_scene_features(view, tree, config.cut);
  config.cut.black_level = features.black_level;
  config.use_tree = features.tree;
  if (options.method == any_method) {
    const MethodChoice choice = choose_method(view, tree, features, options.threshold, config.cut);
    config.method = choice.method;
    config.cut.threshold = choice.threshold;
  }
  const bool uses_tree = config.method == methods::lightcuts ? features.tree : config.method->cuts;
  Rendering rendering;
  {
    ProgressLine line("render " + options.open.spec);
    config.progress = line.progress();
    rendering = render(view, tree, config);
  }
  std::vector<oracle::GroupPicture> groups;
  if (options.groups) {
    ProgressLine line("render groups of " + options.open.spec);
    config.progress = line.progress();
    groups = oracle::render_groups(view, config, build_config_for(options));
  }
  oracle::write_pictures({rendering, nullptr, features.black_level, scene.name, options.seed,
                          config.cut.threshold, groups},
                         folder);
  folder.commit();

  if (rendering.surface_pixels == 0)
    fmt::print(stderr, "{}: the camera sees no surface\n", scene.name);
  const double cut_size = mean(rendering.cut_size, rendering.surface_pixels);
  const double rays = mean(rendering.shadow_rays, rendering.surface_pixels);
  const nlohmann::ordered_json json{{"schema", "lightcuts-oracle/render/1"},
                                    {"scene", options.open.spec},
                                    {"method", config.method->name},
                                    {"builder", name_of(options.open.builder)},
                                    {"seed", options.seed},
                                    {"threshold", oracle::same_digits(config.cut.threshold)},
                                    {"seconds", rendering.seconds},
                                    {"mean_cut_size", cut_size},
                                    {"shadow_rays_per_pixel", rays},
                                    {"light_tree", uses_tree},
                                    {"groups", json_of(groups)},
                                    {"folder", out.string()}};
  const std::string table = fmt::format(
      "{}, {}: {:.2f} s, {:.1f} of {} lights and {:.1f} shadow rays per pixel{}\n{}written to {}\n",
      scene.name, config.method->name, rendering.seconds, cut_size, scene.lights.size(), rays,
      uses_tree || !config.method->cuts ? "" : " (no light tree: it would not pay)",
      table_of(groups), out.string());
  print_results(options, table, text_of(json));
  return all_holds;
}

} // namespace

void add_render_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<RenderOptions>();
  options->open.spec = "desk";
  CLI::App* command =
      app.add_subcommand("render", "Render a scene: EXR with all layers, PNG and heat maps.");
  add_common_options(*command, *options);
  options::add_threshold_option(*command, options->threshold);
  options::add_builder_option(*command, options->open.builder);
  add_out_option(*command, *options);
  std::vector<std::string> methods = method_names();
  methods.insert(methods.begin(), any_method);
  command
      ->add_option("--method", options->method,
                   "how pixels are lit; auto: what is expected to be soonest, see info")
      ->check(CLI::IsMember(methods))
      ->capture_default_str();
  command->add_flag("--groups", options->groups,
                    "render each group of lights by itself, too; default: the whole only");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
