// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/view/method_choice.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/progress_line.h>
#include <oracle/numbers/same_digits.h>
#include <oracle/options/scene_options.h>
#include <oracle/report/plots/pictures.h>

namespace lightcuts::cli {
namespace {

constexpr const char* any_method = "auto";

struct RenderOptions : CommonOptions {
  std::string method = any_method;
};

double mean(const std::vector<float>& values, std::uint64_t count) {
  double sum = 0;
  for (const float v : values) sum += v;
  return count == 0 ? 0 : sum / double(count);
}

int run(const RenderOptions& options) {
  const Scene scene = open_lit_scene_for(options);
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
  oracle::write_pictures(
      {rendering, nullptr, features.black_level, scene.name, options.seed, config.cut.threshold},
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
                                    {"folder", out.string()}};
  const std::string table = fmt::format(
      "{}, {}: {:.2f} s, {:.1f} of {} lights and {:.1f} shadow rays per pixel{}\nwritten to {}\n",
      scene.name, config.method->name, rendering.seconds, cut_size, scene.lights.size(), rays,
      uses_tree || !config.method->cuts ? "" : " (no light tree: it would not pay)", out.string());
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
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
