// SPDX-License-Identifier: MIT
#include <lightcuts/core/shading/box_sight.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/shading/sight.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

double both_bounds(const BoxSight& box) {
  return box.min_half_tangent2(box.max_cosine_quickly(), box.min_between_cosine_quickly());
}

// Sight's own errors: 2^-50 of the tangent, 2^-34 of n.l and of n.v.
bool not_above(double bound2, double tangent2) {
  return std::sqrt(bound2) <= std::sqrt(tangent2) * (1 + 0x1p-33) + 0x1p-50;
}

RC_GTEST_PROP(BoxSight, BoundsTheHalfVectorsTangentFromBelow, ()) {
  const gen::Scene scene = *gen::scene_of(LightKind::omni, 3, false);
  const ShadingPoint point = scene.view.point();
  RC_PRE(point.viewer_cosine() > 0);
  Box box = Box::empty();
  for (const Light& light : scene.lights) box.extend(light.position);
  const BoxSight sight{point, point.position(), box, 1, 1};
  for (const Light& light : scene.lights) {
    const Sight one(point, light.kind, light.position);
    if (one.below_horizon()) continue;
    RC_ASSERT(not_above(sight.min_half_tangent2(), one.half_tangent2()));
    RC_ASSERT(not_above(both_bounds(sight), one.half_tangent2()));
  }
}

// Of one light, a quarter turn away from the viewer around the normal.
TEST(BoxSight, KnowsMoreOfTheHalfVectorAsideOfThePlaneOfIncidence) {
  const ShadingFrame frame(glm::vec3(0), {0, 0, 1}, {0.8F, 0, 0.6F});
  const Box aside{{0, 0.8F, 0.6F}, {0, 0.8F, 0.6F}};
  const BoxSight sight{frame, glm::vec3(0), aside, 1, 1};
  const double real = Sight(frame, LightKind::omni, aside.lo).half_tangent2();
  EXPECT_LT(sight.min_half_tangent2(), 0.9 * real);
  EXPECT_NEAR(both_bounds(sight), real, 1e-5);
}

} // namespace
} // namespace lightcuts
