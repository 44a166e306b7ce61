// SPDX-License-Identifier: MIT
#include <oracle/report/light_groups.h>

#include <algorithm>
#include <utility>

#include <lightcuts/render/view/scene_features.h>
#include <oracle/report/image_error.h>

namespace lightcuts::oracle {
namespace {

double sum_of(const std::vector<glm::vec3>& pixels) {
  double sum = 0;
  for (const glm::vec3& pixel : pixels) sum += channel_sum(pixel);
  return sum;
}

/// The set of that name; new, clamped as the scene's, where there is none.
LightSet& set_named(std::vector<std::pair<std::string, LightSet>>& sets, const std::string& name,
                    const LightSet& all) {
  const auto known =
      std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return set.first == name; });
  if (known != sets.end()) return known->second;
  LightSet fresh;
  if (all.min_distance() > 0) fresh.set_min_distance(all.min_distance());
  sets.emplace_back(name, std::move(fresh));
  return sets.back().second;
}

} // namespace

double GroupPicture::light() const { return sum_of(rendering.radiance); }
double GroupPicture::certified_error() const { return sum_of(rendering.certified_error); }

std::vector<std::pair<std::string, LightSet>> lights_by_group(const Scene& scene) {
  std::vector<std::pair<std::string, LightSet>> sets;
  if (scene.groups.empty()) return sets;
  std::vector<bool> grouped(scene.lights.size(), false);
  for (const LightGroup& group : scene.groups)
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      set_named(sets, group.name, scene.lights).add(scene.lights[i]);
      grouped[i] = true;
    }
  for (std::size_t i = 0; i < grouped.size(); ++i)
    if (!grouped[i]) set_named(sets, "others", scene.lights).add(scene.lights[i]);
  return sets;
}

std::vector<GroupPicture> render_groups(const SceneView& view, const RenderConfig& config,
                                        const BuildConfig& builder) {
  std::vector<GroupPicture> pictures;
  Scene part = view.scene();
  for (auto& [name, lights] : lights_by_group(view.scene())) {
    part.lights = std::move(lights);
    const SceneView relit = view.relit(part);
    const LightTree tree = build(part.lights, builder);
    RenderConfig own = config;
    own.use_tree = find_scene_features(relit, tree, config.cut).tree;
    pictures.push_back({name, part.lights.size(), render(relit, tree, own)});
    config.progress.leave_if_cancelled();
  }
  return pictures;
}

} // namespace lightcuts::oracle
