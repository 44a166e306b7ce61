// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/bounds.h>

#include <cmath>

#include <gtest/gtest.h>

namespace lightcuts {
namespace {

TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, -3}, {99, 99, 99}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  return mesh;
}

TEST(Bounds, hold_every_position_that_a_triangle_uses) {
  const Box box = scene_bounds(two_triangles());
  EXPECT_EQ(box.lo, glm::vec3(0, 0, -3));
  EXPECT_EQ(box.hi, glm::vec3(1, 2, 0));
}

TEST(Bounds, are_empty_without_triangles) {
  TriangleMesh mesh = two_triangles();
  mesh.triangles.clear();
  EXPECT_EQ(scene_bounds(mesh), Box::empty());
  EXPECT_EQ(diagonal_length(scene_bounds(mesh)), 0);
}

TEST(Bounds, measure_the_diagonal) {
  EXPECT_DOUBLE_EQ(diagonal_length({{-1, 0, 0}, {1, 3, 6}}), 7);
  EXPECT_EQ(diagonal_length({{1, 1, 1}, {1, 1, 1}}), 0);
}

TEST(Bounds, do_not_overflow) {
  const double diagonal = diagonal_length({glm::vec3(-3e38F), glm::vec3(3e38F)});
  EXPECT_NEAR(diagonal, 6e38 * std::sqrt(3.0), 1e32);
}

} // namespace
} // namespace lightcuts
