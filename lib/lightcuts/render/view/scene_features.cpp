// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/scene_features.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <lightcuts/core/cut/sum_lights.h>

namespace lightcuts {
namespace {

// Nanoseconds on one core of a 2020s x86-64 server, from renders of `cloud` and `bedroom`; only
// their ratios matter, and those are much the same elsewhere.
constexpr double cost_of_light = 12;            // transfer() and a product
constexpr double cost_of_diffuse_cluster = 330; // two bounds, the heap, and a light
constexpr double cost_of_glossy_cluster = 500;
constexpr double cost_of_ray = 190;

bool any_specular(const Scene& scene) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                     [](const Surface& s) { return s.material.is_glossy(); });
}

std::vector<VisiblePoint> pilot_points(const SceneView& view) {
  constexpr glm::uvec2 grid(16, 12);
  std::vector<VisiblePoint> points;
  for (unsigned y = 0; y < grid.y; ++y)
    for (unsigned x = 0; x < grid.x; ++x) {
      const glm::uvec2 pixel((2 * x + 1) * view.size().x / (2 * grid.x),
                             (2 * y + 1) * view.size().y / (2 * grid.y));
      if (auto p = view.at(pixel)) points.push_back(*p);
    }
  return points;
}

struct Pilot {
  double clusters = 0, cost = 0, radiance = 0; ///< means over the points
};

Pilot run_pilot(const SceneView& view, const LightTree& tree, const CutConfig& config,
                const std::vector<VisiblePoint>& points) {
  const double cost_of_cluster =
      any_specular(view.scene()) ? cost_of_glossy_cluster : cost_of_diffuse_cluster;
  CutConfig cut_config = config;
  cut_config.unoccluded = !view.may_occlude();
  CutSelector select(tree, cut_config);
  Pilot pilot;
  for (const VisiblePoint& p : points) {
    const Cut cut = select(p.point, [&](std::uint32_t light) { return view.sees(p, light); });
    pilot.clusters += double(cut.clusters.size());
    pilot.cost += cost_of_cluster * double(cut.clusters.size()) +
                  (view.may_occlude() ? cost_of_ray * cut.shadow_rays : 0);
    const double radiance = (double(cut.radiance.x) + cut.radiance.y + cut.radiance.z) / 3;
    if (std::isfinite(radiance)) pilot.radiance += radiance;
  }
  const double count = std::max(1.0, double(points.size()));
  return {pilot.clusters / count, pilot.cost / count, pilot.radiance / count};
}

double cost_of_sum(const SceneView& view, const std::vector<VisiblePoint>& points) {
  const LightSet& lights = view.scene().lights;
  double rays = 0;
  if (view.may_occlude())
    for (const VisiblePoint& p : points)
      rays += sum_lights(lights, p.point, [](std::uint32_t) { return false; }).shadow_rays;
  return cost_of_light * double(lights.size()) +
         cost_of_ray * rays / std::max(1.0, double(points.size()));
}

} // namespace

float default_threshold(const SceneView& view) {
  const LightKinds kinds = view.scene().lights.kinds();
  if (view.may_occlude()) return (kinds & ~kinds_with_axis) != 0 ? 0.01F : 0.005F;
  if ((kinds & kinds_with_axis) != 0) return 0.02F;
  return any_specular(view.scene()) ? 0.16F : 0.5F;
}

SceneFeatures find_scene_features(const SceneView& view, const LightTree& tree,
                                  const CutConfig& config) {
  SceneFeatures features;
  features.kinds = view.scene().lights.kinds();
  features.clamp = view.scene().lights.min_distance() > 0;
  features.specular = any_specular(view.scene());
  features.occlusion = view.may_occlude();
  const auto points = pilot_points(view);
  features.black_level = to_float(0x1p-11 * run_pilot(view, tree, config, points).radiance);
  CutConfig with_black = config;
  with_black.black_level = features.black_level;
  const Pilot pilot = run_pilot(view, tree, with_black, points);
  features.pilot_cut_size = pilot.clusters;
  features.pilot_cost_of_cuts = pilot.cost;
  features.pilot_cost_of_sums = cost_of_sum(view, points);
  features.sees_surface = !points.empty();
  features.tree = features.sees_surface && pilot.cost < features.pilot_cost_of_sums;
  return features;
}

} // namespace lightcuts
