// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/point_properties.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/generators.h"
#include "judged_point.h"

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto conserves = Property::tree_conserves_intensity;
constexpr auto belongs = Property::representative_belongs;

Tally judge(const LightTree& tree) {
  Tally tally;
  check_tree(tree, tally);
  return tally;
}

/// What is found wrong with the tree of four lights after `change` of its nodes.
template <class Change>
std::vector<Property> violated_after(Change&& change) {
  const LightTree tree = four_lights();
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  change(nodes);
  return violated(judge(LightTree(tree.lights(), nodes)));
}

std::size_t first_leaf(const std::vector<TreeNode>& nodes) {
  std::size_t i = 0;
  while (!nodes[i].is_leaf()) ++i;
  return i;
}

RC_GTEST_PROP(TreeProperties, HoldForTheLibrary, ()) {
  const LightTree tree = build((*gen::scene(64)).light_set());
  const Tally tally = judge(tree);
  RC_ASSERT(tally.violations() == 0U);
  RC_ASSERT(tally[conserves].cases == tree.nodes().size());
  RC_ASSERT(tally[belongs].cases == tree.nodes().size());
}

TEST(TreeProperties, HaveNothingToSayOfNoTree) { EXPECT_EQ(judge(LightTree())[belongs].cases, 0U); }

TEST(TreeProperties, HoldForTheFourLights) {
  EXPECT_THAT(violated_after([](auto&) {}), IsEmpty());
}

// The root's allowance is height * 2^-53 * 15, here at most 3 ulps.
TEST(TreeProperties, ConvictARootThatIsAFewUlpsOff) {
  for (const double ulps : {-4.0, 4.0})
    EXPECT_THAT(violated_after([&](auto& nodes) { nodes[0].intensity.x += ulps * 0x1p-49; }),
                ElementsAre(conserves));
}

TEST(TreeProperties, AllowARootThatIsRoundedOnceInEachLevel) {
  EXPECT_THAT(violated_after([&](auto& nodes) { nodes[0].intensity.x += 0x1p-49; }), IsEmpty());
}

TEST(TreeProperties, ConvictALeafThatIsOneUlpOff) {
  EXPECT_THAT(violated_after([](auto& nodes) {
                double& blue = nodes[first_leaf(nodes)].intensity.z;
                blue = std::nextafter(blue, 1e9);
              }),
              ElementsAre(conserves));
}

TEST(TreeProperties, ConvictAnIntensityThatIsNotANumber) {
  EXPECT_THAT(violated_after([](auto& nodes) { nodes[0].intensity.y = std::nan(""); }),
              ElementsAre(conserves));
}

TEST(TreeProperties, ConvictAForeignRepresentative) {
  EXPECT_THAT(violated_after([](auto& nodes) {
                // A light of one half stands for the other half.
                std::vector<TreeNode> old = nodes;
                const std::uint32_t a = nodes[0].first_child;
                const std::uint32_t inner = nodes[a].is_leaf() ? a + 1 : a;
                nodes[inner].representative = nodes[inner == a ? a + 1 : a].representative;
              }),
              testing::Contains(belongs));
}

TEST(TreeProperties, ConvictARepresentativeThatIsNoLight) {
  EXPECT_THAT(violated_after([](auto& nodes) { nodes[0].representative = 4; }),
              ElementsAre(belongs));
}

// Every cluster above still has the representative of one of its children.
TEST(TreeProperties, ConvictALightInTwoLeaves) {
  const LightTree tree = four_lights();
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  for (const TreeNode& node : tree.nodes()) {
    const std::uint32_t a = node.first_child;
    if (node.is_leaf() || !nodes[a].is_leaf() || !nodes[a + 1].is_leaf()) continue;
    nodes[a].representative = nodes[a + 1].representative = node.representative;
    break;
  }
  EXPECT_EQ(judge(LightTree(tree.lights(), nodes))[belongs].violations, 1U);
}

TEST(TreeProperties, NameTheNode) {
  const LightTree tree = four_lights();
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  nodes[0].representative = 9;
  EXPECT_EQ(judge(LightTree(tree.lights(), nodes))[belongs].first_violation,
            "node 0: representative 9 is not of this cluster");
}

} // namespace
} // namespace lightcuts::oracle
