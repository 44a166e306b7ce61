// SPDX-License-Identifier: MIT
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/files/text.h>
#include <lightcuts/render/lighting/profiles/profile_light.h>
#include <lightcuts/render/scene/bounds.h>
#include <lightcuts/render/view/method_choice.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/numbers/same_digits.h>
#include <oracle/options/scene_options.h>
#include <oracle/options/values.h>
#include <oracle/report/measure.h>

namespace lightcuts::cli {
namespace {

struct Facts {
  std::size_t emissive = 0;
  Box box;
  std::vector<std::string> needed, left_out;
  float black_level = 0;
  oracle::KernelSaving saving;
  std::string method; ///< that `render` takes, and why
};

std::string describe(const MethodChoice& choice, const SceneFeatures& features) {
  const bool sums = choice.method == methods::lightcuts && !features.tree;
  return fmt::format("{}{}; expected cost, all lights 1: cuts for each pixel {:.2f}, cuts that "
                     "neighbours share {:.2f} ({:.0f} clusters and {:.0f} rays a pixel)",
                     choice.method->name,
                     sums ? ", summing all lights"
                          : fmt::format(" at {:g} %", 100 * oracle::same_digits(choice.threshold)),
                     choice.cost_of_cuts, choice.cost_of_blocks, choice.block_clusters,
                     choice.block_rays);
}

Facts facts_of(const Scene& scene, const CommonOptions& options) {
  Facts facts;
  for (const std::uint32_t s : scene.mesh.surface)
    facts.emissive += scene.surfaces[s].emission != glm::vec3(0) ? 1 : 0;
  facts.box = scene_bounds(scene.mesh);
  if (scene.lights.empty()) return facts;
  const SceneView view(scene);
  const LightTree tree = build(scene.lights, build_config_for(options));
  const float threshold = threshold_for(options, view);
  const SceneFeatures features = find_scene_features(view, tree, {threshold, options.max_cut, 0});
  facts.black_level = features.black_level;
  oracle::describe_features(view, features, threshold, facts.needed, facts.left_out);
  if (features.sees_surface)
    facts.method = describe(choose_method(view, tree, features, options.threshold,
                                          {threshold, options.max_cut, features.black_level}),
                            features);
  facts.saving = oracle::measure_kernels(scene, tree, features, {threshold, options.max_cut, 0});
  return facts;
}

/// "216 omni, 2000 oriented".
std::string lights_by_kind(const LightSet& lights) {
  std::size_t counts[light_kind_count] = {};
  for (const Light& light : lights) ++counts[static_cast<int>(light.kind)];
  std::string text;
  for (int kind = 0; kind < light_kind_count; ++kind)
    if (counts[kind] > 0)
      text +=
          fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[kind], name_of(LightKind(kind)));
  return text.empty() ? "none" : text;
}

/// Lights with profiles.
struct LuminaireFacts {
  std::size_t lights = 0, profiles = 0;
  glm::dvec3 watts{0}; ///< that they send, per channel
};

LuminaireFacts luminaires_of(const LightSet& lights) {
  LuminaireFacts facts;
  std::map<const ProfileTable*, double> solid_shares;
  for (const Light& light : lights) {
    if (light.kind != LightKind::profile) continue;
    const ProfileTable& table = light.profile.table();
    const auto [known, is_new] = solid_shares.try_emplace(&table);
    if (is_new) known->second = solid_share(table);
    facts.watts += known->second * glm::dvec3(light.intensity);
    ++facts.lights;
  }
  facts.profiles = solid_shares.size();
  return facts;
}

std::string table_of(const Scene& scene, const Facts& facts) {
  const glm::vec3& lo = facts.box.lo;
  const glm::vec3& hi = facts.box.hi;
  std::string text = fmt::format(
      "scene        {}\ntriangles    {}\nsurfaces     {}\nlights       {}\nimage        "
      "{} x {}\nbox          ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}) m\n",
      scene.name, scene.mesh.triangles.size(), scene.surfaces.size(), lights_by_kind(scene.lights),
      scene.image_size.x, scene.image_size.y, lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
  if (const LuminaireFacts l = luminaires_of(scene.lights); l.lights > 0)
    text += fmt::format("luminaires   {} of {}, which send {:.4g}, {:.4g}, {:.4g} W\n", l.lights,
                        counted(l.profiles, "profile"), l.watts.r, l.watts.g, l.watts.b);
  for (const LightGroup& group : scene.groups)
    text += fmt::format("group        {}: {}\n", group.name, counted(group.count, "light"));
  text += fmt::format("camera       --camera {}\n", options::camera_text(scene.camera));
  if (facts.emissive > 0)
    text +=
        fmt::format("emission     {} triangles glow for the camera; they light nothing but through "
                    "area lights\n",
                    facts.emissive);
  if (scene.lights.empty()) return text + "no lights: add some with --lights 1000\n";
  text += fmt::format("black level  {:.3g} (radiance below which errors are not chased)\n",
                      facts.black_level);
  for (const std::string& line : facts.needed) text += "needed       " + line + "\n";
  for (const std::string& line : facts.left_out) text += "left out     " + line + "\n";
  if (!facts.method.empty()) text += "method       " + facts.method + "\n";
  const oracle::KernelSaving& s = facts.saving;
  text += fmt::format(
      "saved        {:.2f} times as fast as the general kernel, which leaves nothing "
      "out ({:.3g} s against {:.3g} s for a small picture)\n",
      s.general_seconds / s.specialised_seconds, s.specialised_seconds, s.general_seconds);
  return text;
}

std::string json_of(const CommonOptions& options, const Scene& scene, const Facts& facts) {
  const LuminaireFacts luminaires = luminaires_of(scene.lights);
  const nlohmann::ordered_json json{
      {"schema", "lightcuts-oracle/info/1"},
      {"scene", options.open.spec},
      {"builder", name_of(options.open.builder)},
      {"triangles", scene.mesh.triangles.size()},
      {"surfaces", scene.surfaces.size()},
      {"lights", scene.lights.size()},
      {"luminaires",
       {{"lights", luminaires.lights},
        {"profiles", luminaires.profiles},
        {"watts", {luminaires.watts.r, luminaires.watts.g, luminaires.watts.b}}}},
      {"width", scene.image_size.x},
      {"height", scene.image_size.y},
      {"box",
       {{facts.box.lo.x, facts.box.lo.y, facts.box.lo.z},
        {facts.box.hi.x, facts.box.hi.y, facts.box.hi.z}}},
      {"camera", options::camera_text(scene.camera)},
      {"emissive_triangles", facts.emissive},
      {"black_level", facts.black_level},
      {"needed", facts.needed},
      {"left_out", facts.left_out},
      {"method", facts.method},
      {"general_kernel_seconds", facts.saving.general_seconds},
      {"specialised_kernel_seconds", facts.saving.specialised_seconds},
      {"notes", scene.notes}};
  return text_of(json);
}

int run(const CommonOptions& options) {
  JsonFolder folder(options);
  const Scene scene = open_scene_for(options);
  const Facts facts = facts_of(scene, options);
  const std::string json = json_of(options, scene, facts);
  folder.write("info.json", json);
  print_results(options, table_of(scene, facts), json);
  return all_holds;
}

} // namespace

void add_info_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CommonOptions>();
  options->open.spec = "desk";
  CLI::App* command =
      app.add_subcommand("info", "Say what is in a scene, what it needs, and what is left out.");
  add_common_options(*command, *options);
  options::add_threshold_option(*command, options->threshold);
  options::add_builder_option(*command, options->open.builder);
  add_json_folder_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace lightcuts::cli
