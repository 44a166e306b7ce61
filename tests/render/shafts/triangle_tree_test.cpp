// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/triangle_tree.h>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <oracle/numbers/dice.h>

namespace lightcuts {
namespace {

TEST(TriangleTree, HasEachTriangleWithAreaOnceWithinItsBoxes) {
  gen::Dice dice(2);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 600; i += 3) {
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(dice.in_cube());
    mesh.triangles.emplace_back(i, i + 1, i + 2);
  }
  mesh.triangles.emplace_back(0, 1, 1); // no area
  const TriangleTree tree(mesh);
  EXPECT_EQ(tree.triangles().size(), 200U);
  std::vector<int> count(200, 0);
  for (const TriangleTree::Node& node : tree.nodes()) {
    if (node.count == 0) {
      EXPECT_TRUE(node.box.contains(tree.nodes()[node.first].box));
      EXPECT_TRUE(node.box.contains(tree.nodes()[node.first + 1].box));
    }
    for (std::uint32_t k = 0; k < node.count; ++k) {
      ++count[node.first + k];
      for (const glm::dvec3& p : tree.triangles()[node.first + k].corners)
        EXPECT_TRUE(node.box.contains(glm::vec3(p)));
    }
  }
  EXPECT_EQ(std::ranges::count(count, 1), 200);
}

TEST(TriangleTree, KnowsShapesAndPartnersAcrossTheLongestEdge) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 1e-20F}, {1e-20F, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}};
  const TriangleTree tree(mesh);
  ASSERT_EQ(tree.triangles().size(), 3U);
  int paired = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const FlatTriangle& t = tree.triangles()[i];
    if (t.longest < 1) {
      EXPECT_EQ(t.slimness, std::numeric_limits<double>::infinity());
      EXPECT_EQ(t.partner, i);
      continue;
    }
    ++paired;
    EXPECT_NE(t.partner, i);
    EXPECT_EQ(tree.triangles()[t.partner].partner, i);
    EXPECT_NEAR(t.longest, std::sqrt(8.0), 1e-12);
    EXPECT_NEAR(t.slimness, 2, 1e-12);
    EXPECT_NEAR(std::abs(t.height({5, 5, 3})), 3, 1e-12);
  }
  EXPECT_EQ(paired, 2);
}

} // namespace
} // namespace lightcuts
