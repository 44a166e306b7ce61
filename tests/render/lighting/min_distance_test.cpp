// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/min_distance.h>

#include <gtest/gtest.h>

#include <tests/render/support/box_scene.h>

namespace lightcuts {
namespace {

TEST(SuggestedMinDistance, is_the_radius_of_the_disc_that_a_light_stands_for) {
  const Scene box = test::closed_box({1, 2, 3}, glm::vec3(0.5F)); // 22 m^2
  for (const std::size_t count : {1U, 100U}) {
    const double d = suggested_min_distance(box.mesh, count);
    EXPECT_NEAR(3.14159265358979 * d * d * double(count), 22, 1e-5);
  }
}

TEST(SuggestedMinDistance, is_0_without_area) {
  EXPECT_EQ(suggested_min_distance(TriangleMesh(), 5), 0);
}

} // namespace
} // namespace lightcuts
