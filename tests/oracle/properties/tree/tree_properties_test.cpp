// SPDX-License-Identifier: MIT
#include <oracle/properties/judge.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto conserves = Property::tree_conserves_intensity;
constexpr auto belongs = Property::representative_belongs;
constexpr auto partitions = Property::tree_partitions_lights;

Tally judge(TreeClaim claim, const LightSet& lights) {
  Tally tally;
  (void)Judge(0, 7, tally).tree(std::move(claim), lights);
  return tally;
}

Tally judge(const LightTree& tree) { return judge(claim_of(tree), tree.lights()); }

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

TEST(TreeProperties, HaveNothingToSayOfNoLights) {
  const Tally tally = judge(LightTree());
  EXPECT_EQ(tally[partitions].violations, 0U);
  EXPECT_EQ(tally[belongs].cases, 0U);
}

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
                const std::uint32_t a = nodes[0].first_child;
                const std::uint32_t inner = nodes[a].is_leaf() ? a + 1 : a;
                nodes[inner].representative = nodes[inner == a ? a + 1 : a].representative;
              }),
              testing::Contains(belongs));
}

TEST(TreeProperties, ConvictARepresentativeThatIsNoLight) {
  EXPECT_THAT(violated_after([](auto& nodes) { nodes[0].representative = 4; }),
              ElementsAre(partitions));
}

// Every cluster has the representative of one of its children.
TEST(TreeProperties, ConvictALightInTwoLeaves) {
  const LightTree tree = four_lights();
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  for (const TreeNode& node : tree.nodes()) {
    const std::uint32_t a = node.first_child;
    if (node.is_leaf() || !nodes[a].is_leaf() || !nodes[a + 1].is_leaf()) continue;
    nodes[a].representative = nodes[a + 1].representative = node.representative;
    break;
  }
  EXPECT_THAT(violated(judge(LightTree(tree.lights(), nodes))), ElementsAre(partitions, conserves));
}

TEST(TreeProperties, NameTheNode) {
  LightSet lights;
  for (int i = 0; i < 2; ++i) lights.add_omni({0, 0, i}, glm::vec3(1));
  const TreeClaim of_one{{{.light_count = 1, .representative = 1}}, {}, {0}};
  const Tally tally = judge(of_one, lights);
  EXPECT_THAT(violated(tally), ElementsAre(partitions, belongs));
  EXPECT_EQ(tally[belongs].first_violation, "node 0: representative 1 is not of this cluster");
  EXPECT_EQ(tally[partitions].first_violation, "light 1 is in 0 leaves");
}

TEST(TreeProperties, DoNotAskForWhatIsNotSaid) {
  LightSet lights;
  lights.add_omni({0, 0, 1}, glm::vec3(1));
  const Tally tally = judge({{{.light_count = 1}}, {}, {0}}, lights);
  EXPECT_EQ(tally[partitions].cases, 1U);
  EXPECT_EQ(tally[belongs].cases + tally[conserves].cases, 0U);
}

/// A root over `leaves` leaves, which share the lights of intensity 0.1 evenly, in the order of
/// summation; its intensity is off by so many half ulps of the sum.
TreeClaim wide_claim(std::uint32_t lights, std::uint32_t leaves, double half_ulps) {
  TreeClaim claim;
  const double sum = double(0.1F) * lights;
  claim.nodes.push_back({.child_count = leaves, .intensity = glm::dvec3(sum)});
  claim.nodes[0].intensity->x *= 1 + half_ulps * 0x1p-53;
  for (std::uint32_t i = 0; i < lights; ++i) claim.lights.push_back(i);
  for (std::uint32_t i = 0; i < leaves; ++i) {
    claim.nodes.push_back({.first_light = i * (lights / leaves), .light_count = lights / leaves});
    claim.children.push_back(i + 1);
  }
  return claim;
}

// n terms are n - 1 additions, however they are spread over levels.
TEST(TreeProperties, AllowOneRoundingForEachAddition) {
  LightSet lights;
  for (int i = 0; i < 12; ++i) lights.add_omni({0, 0, i}, glm::vec3(0.1F));
  EXPECT_THAT(violated(judge(wide_claim(12, 12, 10), lights)), IsEmpty());
  EXPECT_THAT(violated(judge(wide_claim(12, 12, 14), lights)), ElementsAre(conserves));
  EXPECT_THAT(violated(judge(wide_claim(12, 3, 4), lights)), IsEmpty());
  EXPECT_THAT(violated(judge(wide_claim(12, 3, 8), lights)), ElementsAre(conserves));
}

} // namespace
} // namespace lightcuts::oracle
