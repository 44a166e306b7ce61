// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/cluster_estimate.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  return cluster_estimate(tree, node, point, contribution_bound(tree, node, point));
}

RC_GTEST_PROP(ClusterEstimate, OfALeafIsItsLightsContribution, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const Light& light = tree.lights()[tree.node(i).representative];
    if (tree.node(i).is_leaf())
      RC_ASSERT(estimate(tree, i, point) ==
                transfer(point, light, scene.min_distance) * glm::dvec3(light.intensity));
  }
}

RC_GTEST_PROP(ClusterEstimate, IsNeverNaNOrNegative, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const glm::dvec3 e = estimate(tree, i, point);
    for (int c = 0; c < 3; ++c) RC_ASSERT(e[c] >= 0);
  }
}

/// Fifty lights of a kind in a box of a given size.
LightSet shrunk_lights(LightKind kind, float size) {
  LightSet lights;
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 offset(float(i * 7 % 11) / 11, float(i * 5 % 13) / 13, float(i * 3 % 17) / 17);
    const glm::vec3 p = glm::vec3(1, 2, 3) + size * offset;
    if (kind == LightKind::omni) lights.add_omni(p, glm::vec3(1));
    if (kind == LightKind::oriented) lights.add_oriented(p, {0, 0, -1}, glm::vec3(1));
    if (kind == LightKind::directional) lights.add_directional(-glm::normalize(p), glm::vec3(1));
  }
  return lights;
}

/// Relative error of the estimate for a cloud of lights shrunk to a given size.
double error_at_size(LightKind kind, float size) {
  const LightSet lights = shrunk_lights(kind, size);
  const ShadingPoint point({0, 0, 0}, {0, 0.6F, 0.8F}, {0, 0, 1}, {glm::vec3(1), {}});
  const double exact = sum_lights(lights, point, [](std::uint32_t) { return true; }).radiance.x;
  return std::abs(estimate(build(lights), 0, point).x - exact) / exact;
}

// An error of third order falls to an eighth, one of second order to a quarter: 1/6 tells them
// apart.
TEST(ClusterEstimate, ErrsByTheThirdPowerOfTheSizeWhereTheSurfaceIsDiffuse) {
  for (const auto kind : {LightKind::omni, LightKind::oriented, LightKind::directional}) {
    SCOPED_TRACE(int(kind));
    EXPECT_GT(error_at_size(kind, 1), 1e-6);
    EXPECT_LT(error_at_size(kind, 0.5F), error_at_size(kind, 1) / 6);
    EXPECT_LT(error_at_size(kind, 0.25F), error_at_size(kind, 0.5F) / 6);
  }
}

// Lights that face different ways: their mean axis makes the sum exact as long as all face x.
TEST(ClusterEstimate, OfDivergingAxesIsExactToFirstOrder) {
  LightSet lights;
  lights.add_oriented({0, 0, 2}, {0.6F, 0, -0.8F}, glm::vec3(1));
  lights.add_oriented({0, 0, 2}, {-0.6F, 0, -0.8F}, glm::vec3(3));
  lights.add_oriented({0, 0, 2}, {0, 0.8F, -0.6F}, glm::vec3(2));
  const ShadingPoint point({0.1F, 0.2F, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const double exact = sum_lights(lights, point, [](std::uint32_t) { return true; }).radiance.x;
  EXPECT_NEAR(estimate(build(lights), 0, point).x / exact, 1, 1e-6);
}

} // namespace
} // namespace lightcuts
