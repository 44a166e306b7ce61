// SPDX-License-Identifier: MIT
#include <oracle/subjects/topology.h>

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/subjects/library_subject.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

using Indices = std::vector<std::uint32_t>;

Indices all_lights(const Topology& tree, std::uint32_t node) {
  const auto lights = tree.all_lights(node);
  return {lights.begin(), lights.end()};
}

TreeClaim::Node leaf(std::uint32_t first_light, std::uint32_t count = 1) {
  return {.first_light = first_light, .light_count = count};
}

TreeClaim::Node inner(std::uint32_t first_child, std::uint32_t count) {
  return {.first_child = first_child, .child_count = count};
}

/// A root with a leaf of light 2, a node of three leaves, and a leaf of three lights.
TreeClaim seven_lights() {
  TreeClaim claim;
  claim.nodes = {inner(0, 3), leaf(0), inner(3, 3), leaf(4, 3), leaf(1), leaf(2), leaf(3)};
  claim.children = {1, 2, 3, 4, 5, 6};
  claim.lights = {2, 0, 4, 6, 1, 3, 5};
  return claim;
}

/// What is found wrong after the change; the claim is no tree at all, or only not over all lights.
template <class Change>
std::string defect_after(Change&& change, bool is_tree = false) {
  TreeClaim claim = seven_lights();
  change(claim);
  TopologyReading reading = read_topology(claim, 7);
  EXPECT_EQ(reading.topology.has_value(), is_tree);
  return reading.defect;
}

TEST(Topology, TakesAnyNumberOfChildrenAndOfLightsInALeaf) {
  const TopologyReading reading = read_topology(seven_lights(), 7);
  EXPECT_EQ(reading.defect, "");
  const Topology& tree = reading.topology.value();
  EXPECT_EQ(tree.size(), 7U);
  EXPECT_FALSE(tree.is_leaf(0));
  EXPECT_TRUE(tree.is_leaf(3));
  EXPECT_THAT(tree.children(0), ElementsAre(1, 2, 3));
  EXPECT_THAT(tree.children(2), ElementsAre(4, 5, 6));
  EXPECT_THAT(tree.children(3), IsEmpty());
  EXPECT_THAT(tree.lights(3), ElementsAre(1, 3, 5));
  EXPECT_THAT(tree.lights(2), IsEmpty());
  EXPECT_THAT(all_lights(tree, 2), UnorderedElementsAre(0, 4, 6));
  EXPECT_THAT(all_lights(tree, 0), UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(tree.light_count(0), 7U);
  EXPECT_EQ(tree.light_count(2), 3U);
  EXPECT_EQ(tree.representative(0), TreeClaim::unsaid);
  EXPECT_FALSE(tree.intensity(0));
}

TEST(Topology, KeepsWhatIsSaidOfRepresentativesAndIntensities) {
  TreeClaim claim = seven_lights();
  claim.nodes[2].representative = 4;
  claim.nodes[2].intensity = glm::dvec3(1, 2, 3);
  const Topology tree = read_topology(claim, 7).topology.value();
  EXPECT_EQ(tree.representative(2), 4U);
  EXPECT_EQ(tree.intensity(2), glm::dvec3(1, 2, 3));
}

TEST(Topology, TakesLightsOfNodesThatAreNoLeavesForNothing) {
  TreeClaim claim = seven_lights();
  claim.nodes[0].first_light = 1000;
  claim.nodes[0].light_count = 1000;
  const TopologyReading reading = read_topology(claim, 7);
  EXPECT_EQ(reading.defect, "");
  EXPECT_THAT(reading.topology->lights(0), IsEmpty());
}

TEST(Topology, OfNoLightsIsEmptyOrOfEmptyLeaves) {
  const TopologyReading none = read_topology({}, 0);
  EXPECT_EQ(none.defect, "");
  EXPECT_EQ(none.topology->size(), 0U);
  const TopologyReading empty_leaf = read_topology({{leaf(0, 0)}, {}, {}}, 0);
  EXPECT_EQ(empty_leaf.defect, "");
  EXPECT_EQ(empty_leaf.topology->light_count(0), 0U);
}

TEST(Topology, RefusesNoNodeForSomeLights) {
  const TopologyReading reading = read_topology({}, 3);
  EXPECT_FALSE(reading.topology);
  EXPECT_EQ(reading.defect, "no node for 3 lights");
}

TEST(Topology, RefusesIndicesOutOfRange) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[4] = 7; }),
            "node 2 has node 7 of 7 as a child");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[0] = TreeClaim::unsaid; }),
            "node 0 has node 4294967295 of 7 as a child");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.lights[3] = 7; }), "node 6 has light 7 of 7");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[5].representative = 7; }),
            "node 5 has light 7 of 7 as its representative");
}

TEST(Topology, RefusesRangesBeyondTheLists) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[2].child_count = 4; }),
            "node 2 has children beyond the list of children");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[3].light_count = 4; }),
            "node 3 has lights beyond the list of lights");
  // Whose sum is small again in 32 bits.
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[2].first_child = 0xFFFFFFFE; }),
            "node 2 has children beyond the list of children");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[3].first_light = 0xFFFFFFFE; }),
            "node 3 has lights beyond the list of lights");
}

TEST(Topology, RefusesTheRootAsAChild) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[5] = 0; }), "the root is a child of node 2");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[0] = 0; }), "the root is a child of node 0");
}

TEST(Topology, RefusesACycle) {
  // Above it, and apart from the root.
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[3] = 2; }),
            "node 2 is a child twice, of node 2 at last");
  EXPECT_EQ(defect_after([](TreeClaim& c) {
              c = {{leaf(0), inner(0, 1), inner(1, 1)}, {2, 1}, {0}};
            }),
            "node 1 is nobody's child");
}

TEST(Topology, RefusesASharedChild) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[5] = 3; }),
            "node 3 is a child twice, of node 2 at last");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.children[1] = 1; }),
            "node 1 is a child twice, of node 0 at last");
}

TEST(Topology, RefusesANodeThatIsNobodysChild) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[2].child_count = 2; }),
            "node 6 is nobody's child");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes.push_back(leaf(0, 0)); }),
            "node 7 is nobody's child");
}

TEST(Topology, TellsOfALostLightButIsATree) {
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[3].light_count = 2; }, true),
            "light 5 is in 0 leaves");
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[1].light_count = 0; }, true),
            "light 2 is in 0 leaves");
}

TEST(Topology, TellsOfADoubledLightButIsATree) {
  // In another leaf, and in the same; the latter loses light 6, too.
  EXPECT_EQ(defect_after([](TreeClaim& c) { c.nodes[3].first_light = 3; }, true),
            "light 5 is in 0 leaves");
  EXPECT_EQ(defect_after(
                [](TreeClaim& c) {
                  c.lights.push_back(1);
                  ++c.nodes[3].light_count;
                },
                true),
            "light 1 is in 2 leaves");
}

TEST(Topology, CountsLightsWithRepetition) {
  TreeClaim claim = seven_lights();
  claim.lights.push_back(1);
  ++claim.nodes[3].light_count;
  const Topology tree = read_topology(claim, 7).topology.value();
  EXPECT_EQ(tree.light_count(0), 8U);
  EXPECT_THAT(all_lights(tree, 0), SizeIs(8));
}

/// The claim with its nodes in another order, the root in front.
TreeClaim shuffled(const TreeClaim& claim, std::uint64_t seed) {
  gen::Dice dice(seed);
  Indices place(claim.nodes.size());
  std::iota(place.begin(), place.end(), 0U);
  for (std::size_t i = place.size(); i-- > 2;)
    std::swap(place[i], place[std::size_t(dice.between(1, int(i)))]);
  TreeClaim other = claim;
  for (std::size_t i = 0; i < place.size(); ++i) other.nodes[place[i]] = claim.nodes[i];
  for (std::uint32_t& child : other.children) child = place[child];
  return other;
}

RC_GTEST_PROP(Topology, IsThatOfTheLibrarysTree, ()) {
  const LightSet lights = (*gen::scene(40)).light_set();
  const LightTree tree = build(lights);
  const TopologyReading reading = read_topology(claim_of(tree), lights.size());
  RC_ASSERT(reading.defect == "");
  const Topology& t = *reading.topology;
  RC_ASSERT(t.size() == tree.nodes().size());
  for (std::uint32_t i = 0; i < t.size(); ++i) {
    const TreeNode& node = tree.node(i);
    RC_ASSERT(t.is_leaf(i) == node.is_leaf());
    RC_ASSERT(t.light_count(i) == node.light_count);
    RC_ASSERT(t.representative(i) == node.representative);
    RC_ASSERT(*t.intensity(i) == node.intensity);
    if (node.is_leaf()) continue;
    RC_ASSERT(t.children(i).size() == 2U);
    RC_ASSERT(t.children(i)[0] == node.first_child);
    RC_ASSERT(t.children(i)[1] == node.first_child + 1);
  }
}

RC_GTEST_PROP(Topology, HasEveryNodeOnceAndParentsFirstInAnyOrderOfNodes, ()) {
  const LightSet lights = (*gen::scene(40)).light_set();
  const TreeClaim claim = shuffled(claim_of(build(lights)), *rc::gen::arbitrary<std::uint64_t>());
  const TopologyReading reading = read_topology(claim, lights.size());
  RC_ASSERT(reading.defect == "");
  const Topology& t = *reading.topology;
  std::vector<bool> visited(t.size(), false);
  for (const std::uint32_t node : t.parents_first()) {
    RC_ASSERT(!visited[node]);
    visited[node] = true;
    for (const std::uint32_t child : t.children(node)) RC_ASSERT(!visited[child]);
  }
  RC_ASSERT(t.parents_first().size() == t.size());
  Indices all = all_lights(t, 0);
  std::sort(all.begin(), all.end());
  for (std::uint32_t i = 0; i < lights.size(); ++i) RC_ASSERT(all[i] == i);
}

// Whatever it says, reading it ends, and what is read is safe to walk.
RC_GTEST_PROP(Topology, OfAnyClaimAtAllIsRefusedOrCanBeWalked, ()) {
  gen::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const auto any = [&] { return std::uint32_t(dice.one_in(20) ? dice.bits() : dice.below(6)); };
  TreeClaim claim;
  for (int i = dice.below(6); i > 0; --i)
    claim.nodes.push_back({any(), any() % 3, any(), any() % 3, TreeClaim::unsaid, {}});
  for (int i = dice.below(7); i > 0; --i) claim.children.push_back(any());
  for (int i = dice.below(7); i > 0; --i) claim.lights.push_back(any());
  const TopologyReading reading = read_topology(claim, 5);
  RC_CLASSIFY(reading.topology.has_value());
  RC_ASSERT(reading.topology.has_value() || !reading.defect.empty());
  if (!reading.topology) return;
  RC_ASSERT(reading.topology->parents_first().size() == claim.nodes.size());
  for (const std::uint32_t light : reading.topology->all_lights(0)) RC_ASSERT(light < 5U);
}

} // namespace
} // namespace lightcuts::oracle
