// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/light_tree.h>

#include <gtest/gtest.h>

namespace lightcuts {
namespace {

TEST(LightTree, WithoutLightsIsEmpty) {
  const LightTree tree;
  EXPECT_TRUE(tree.empty());
  EXPECT_TRUE(tree.nodes().empty());
  EXPECT_TRUE(tree.lights().empty());
}

TEST(LightTree, OfOneLightIsOneLeaf) {
  LightSet lights;
  lights.add_omni({1, 2, 3}, {4, 5, 6});
  const LightTree tree(lights, {{{{1, 2, 3}, {1, 2, 3}}, {4, 5, 6}, 0, 0, 1}});
  EXPECT_FALSE(tree.empty());
  EXPECT_TRUE(tree.node(0).is_leaf());
  EXPECT_EQ(tree.lights()[tree.node(0).representative].intensity, glm::vec3(4, 5, 6));
}

TEST(LightTree, KeepsItsOwnCopyOfTheLights) {
  LightSet lights;
  lights.add_omni({1, 2, 3}, {4, 5, 6});
  const LightTree tree(lights, {{{{1, 2, 3}, {1, 2, 3}}, {4, 5, 6}, 0, 0, 1}});
  lights.add_omni({0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(tree.lights().size(), 1U);
}

} // namespace
} // namespace lightcuts
