// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/camera.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

Camera looking_down_z() {
  return {.position = {0, 0, 1}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_fov = 90};
}

void expect_rounded_once(const glm::vec3& a, const glm::vec3& b) {
  // A unit vector computed in double and rounded once: half an ulp per component.
  EXPECT_LE(glm::length(glm::dvec3(a) - glm::dvec3(b)), 0x1p-23);
}

TEST(PinholeView, looks_at_the_target_through_the_middle) {
  const PinholeView view(looking_down_z(), {3, 5});
  expect_rounded_once(view.direction({1, 2}), {0, 0, -1});
  EXPECT_EQ(view.origin(), glm::vec3(0, 0, 1));
}

TEST(PinholeView, has_x_to_the_right_and_y_down) {
  const PinholeView view(looking_down_z(), {2, 2});
  const glm::vec3 top_left = view.direction({0, 0}), bottom_right = view.direction({1, 1});
  expect_rounded_once(top_left, glm::normalize(glm::vec3(-0.5F, 0.5F, -1)));
  expect_rounded_once(bottom_right, glm::normalize(glm::vec3(0.5F, -0.5F, -1)));
}

TEST(PinholeView, spans_the_vertical_field_of_view_with_square_pixels) {
  const PinholeView view(looking_down_z(), {8, 4});
  // At 90 degrees the plane at distance 1 is 2 high and 4 wide: pixels of 0.5.
  expect_rounded_once(view.direction({7, 0}), glm::normalize(glm::vec3(1.75F, 0.75F, -1)));
}

TEST(PinholeView, gives_unit_directions) {
  const Camera camera{{1e8F, -3e7F, 5}, {-2, 1e9F, 7}, {0.1F, 1e-20F, 1}, 179};
  const PinholeView view(camera, {100, 70});
  for (unsigned y = 0; y < 70; ++y)
    for (unsigned x = 0; x < 100; ++x)
      EXPECT_NEAR(glm::length(glm::dvec3(view.direction({x, y}))), 1, 0x1p-23);
}

TEST(PinholeView, keeps_its_directions_under_scaling) {
  Camera small = looking_down_z(), large = small;
  small.position *= 1e-30F, small.up *= 1e-38F;
  large.position *= 1e30F, large.up *= 1e38F;
  const PinholeView a(small, {3, 2}), b(large, {3, 2});
  EXPECT_EQ(a.direction({2, 1}), b.direction({2, 1}));
}

TEST(PinholeView, refuses_what_has_no_view) {
  const auto refused = [](auto change) {
    Camera camera = looking_down_z();
    change(camera);
    EXPECT_THROW(PinholeView(camera, {4, 4}), InputError);
  };
  refused([](Camera& c) { c.target = c.position; });
  refused([](Camera& c) { c.up = {0, 0, 2}; });
  refused([](Camera& c) { c.up = {0, 0, 0}; });
  refused([](Camera& c) { c.vertical_fov = 0; });
  refused([](Camera& c) { c.vertical_fov = 180; });
  refused([&](Camera& c) { c.vertical_fov = nan; });
  refused([&](Camera& c) { c.position.x = nan; });
  refused([](Camera& c) { c.target.y = std::numeric_limits<float>::infinity(); });
  EXPECT_THROW(PinholeView(looking_down_z(), {0, 4}), InputError);
}

} // namespace
} // namespace lightcuts
