// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/method_choice.h>

#include <algorithm>

#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/render/view/pixel_square.h>

namespace lightcuts {
namespace {

// In the units of scene_features.cpp, in which `desk` summed takes 38 where it takes 21 us: what
// was measured there, in `bedroom` and `cloud`, times 38/21. Of a pixel's cut: a cluster with its
// share, one where nothing occludes, and a ray, which is one of few.
constexpr double cost_of_shared_cluster = 260, cost_of_open_cluster = 100;
constexpr double cost_of_shadow_ray = 290;

/// Of the cost of all lights. They are exact, which is worth more than a little time.
constexpr double dearest_for_sums = 0.25;

struct BlockPilot {
  double pixels = 0, clusters = 0, rays = 0;

  void add(const PixelResult& result) {
    pixels += 1;
    clusters += double(result.cut_size);
    rays += double(result.shadow_rays);
  }
};

BlockPilot run_block_pilot(const SceneView& view, const LightTree& tree, const CutConfig& config) {
  constexpr glm::uvec2 grid(5, 4);
  LighterConfig lighter_config{.lights = view.scene().lights, .tree = tree, .cut = config};
  lighter_config.may_occlude = view.may_occlude();
  lighter_config.cut.unoccluded = !view.may_occlude();
  const auto lighter = methods::block_cuts.lighter(lighter_config);
  BlockPilot pilot;
  for (unsigned y = 0; y < grid.y; ++y)
    for (unsigned x = 0; x < grid.x; ++x) {
      const glm::uvec2 pixel((2 * x + 1) * view.size().x / (2 * grid.x),
                             (2 * y + 1) * view.size().y / (2 * grid.y));
      for (const PixelResult& result : light(PixelSquare(view, pixel), view, *lighter))
        pilot.add(result);
    }
  return pilot;
}

} // namespace

float default_block_threshold(const SceneView& view) {
  if (!view.may_occlude()) return default_threshold(view);
  return (view.scene().lights.kinds() & ~kinds_with_axis) != 0 ? 0.04F : 0.01F;
}

MethodChoice choose_method(const SceneView& view, const LightTree& tree,
                           const SceneFeatures& features, std::optional<float> threshold,
                           CutConfig config) {
  MethodChoice choice{methods::lightcuts, threshold.value_or(default_threshold(view)), 0, 0, 0, 0};
  choice.cost_of_cuts = features.pilot_cost_of_cuts / features.pilot_cost_of_sums;
  if (tree.empty()) return choice;
  config.threshold = threshold.value_or(default_block_threshold(view));
  const BlockPilot pilot = run_block_pilot(view, tree, config);
  if (pilot.pixels == 0) return choice;
  choice.block_clusters = pilot.clusters / pilot.pixels;
  choice.block_rays = pilot.rays / pilot.pixels;
  const double cluster = view.may_occlude() ? cost_of_shared_cluster : cost_of_open_cluster;
  choice.cost_of_blocks =
      (cluster * choice.block_clusters + cost_of_shadow_ray * choice.block_rays) /
      features.pilot_cost_of_sums;
  if (choice.cost_of_blocks < (features.tree ? choice.cost_of_cuts : dearest_for_sums)) {
    choice.method = methods::block_cuts;
    choice.threshold = config.threshold;
  }
  return choice;
}

} // namespace lightcuts
