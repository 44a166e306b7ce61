// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/tree_builder.h>

#include <bit>
#include <cmath>
#include <iostream>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/jobs/seconds_since.h>
#include <tests/support/generators.h>
#include <tests/support/naive_difference.h>

namespace lightcuts {
namespace {

std::string difference_from_naive_tree(const LightSet& lights) {
  return difference(build(lights), oracle::naive_clusters(lights));
}

RC_GTEST_PROP(Build, YieldsTheTreeOfTheNaiveBuilder, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, 40)).light_set();
  RC_ASSERT(difference_from_naive_tree(lights) == "");
}

TEST(Build, YieldsTheNaiveTreeOfAFullLattice) {
  LightSet lights; // every distance occurs many times
  for (int i = 0; i < 125; ++i)
    lights.add_omni({i * 7 % 125 % 5, i * 7 % 125 / 5 % 5, i * 7 % 125 / 25}, glm::vec3(1));
  EXPECT_EQ(difference_from_naive_tree(lights), "");
}

TEST(Build, YieldsTheNaiveTreeOfManyCoincidentAndBlackLights) {
  LightSet lights;
  for (int i = 0; i < 120; ++i) lights.add_omni({i % 3, 0, 0}, glm::vec3(i % 4 == 0 ? 0.0F : 1.0F));
  EXPECT_EQ(difference_from_naive_tree(lights), "");
}

std::uint32_t levels_of(const LightTree& tree) {
  std::vector<std::uint32_t> depth(tree.nodes().size(), 0);
  std::uint32_t most = 0;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    most = std::max(most, depth[i]);
    if (tree.node(i).is_leaf()) continue;
    depth[tree.node(i).first_child] = depth[i] + 1;
    depth[tree.node(i).first_child + 1] = depth[i] + 1;
  }
  return most;
}

TEST(Build, HalvesManyLightsAtOnePlace) {
  LightSet omni, oriented;
  for (int i = 0; i < 1 << 12; ++i) {
    omni.add_omni({1, 2, 3}, glm::vec3(float(i)));
    oriented.add_oriented({1, i % 2 == 0 ? 0.0F : -0.0F, 3}, {0, i % 4 < 2 ? 1 : -1, 0},
                          glm::vec3(1));
  }
  EXPECT_EQ(levels_of(build(omni)), 12U);
  EXPECT_EQ(levels_of(build(oriented)), 12U); // two cones of half of them each
}

Builder any_builder() {
  return *rc::gen::elementOf(
      std::vector<Builder>(std::begin(all_builders), std::end(all_builders)));
}

std::set<std::uint32_t> lights_below(const LightTree& tree, std::uint32_t i) {
  const TreeNode& node = tree.node(i);
  if (node.is_leaf()) return {node.representative};
  std::set<std::uint32_t> set = lights_below(tree, node.first_child);
  set.merge(lights_below(tree, node.first_child + 1));
  return set;
}

RC_GTEST_PROP(Build, KeepsKindsApartBelowTheMixedClustersAtTheTop, ()) {
  const LightTree tree = build((*gen::scene(60)).light_set(), {1, any_builder()});
  int mixed = 0;
  for (const TreeNode& node : tree.nodes()) {
    if (node.is_leaf()) {
      RC_ASSERT(node.kind() == tree.lights()[node.representative].kind);
      continue;
    }
    const LightKinds below =
        tree.node(node.first_child).kinds | tree.node(node.first_child + 1).kinds;
    RC_ASSERT(node.kinds == below);
    mixed += node.is_mixed() ? 1 : 0;
  }
  RC_ASSERT(mixed == std::popcount(tree.lights().kinds()) - 1);
}

RC_GTEST_PROP(Build, PutsEveryLightInOneLeaf, ()) {
  const LightSet lights = (*gen::scene(60)).light_set();
  const LightTree tree = build(lights, {1, any_builder()});
  RC_ASSERT(tree.nodes().size() == 2 * lights.size() - 1);
  RC_ASSERT(lights_below(tree, 0).size() == lights.size());
  RC_ASSERT(tree.node(0).light_count == lights.size());
  for (const TreeNode& node : tree.nodes()) {
    if (!node.is_leaf()) continue;
    const Light& light = lights[node.representative];
    RC_ASSERT(node.box == (Box{light.position, light.position}));
    RC_ASSERT(node.intensity == glm::dvec3(light.intensity));
    RC_ASSERT(node.light_count == 1U);
  }
}

RC_GTEST_PROP(Build, MakesEveryNodeTheUnionOfTheTwoChildrenThatFollowIt, ()) {
  const LightTree tree = build((*gen::scene(60)).light_set(), {1, any_builder()});
  std::set<std::uint32_t> children;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const TreeNode& node = tree.node(i);
    if (node.is_leaf()) continue;
    RC_ASSERT(node.first_child > i);
    RC_ASSERT(children.insert(node.first_child).second);
    const TreeNode& a = tree.node(node.first_child);
    const TreeNode& b = tree.node(node.first_child + 1);
    Box both = a.box;
    both.extend(b.box);
    RC_ASSERT(node.box == both);
    RC_ASSERT(node.intensity == a.intensity + b.intensity);
    RC_ASSERT(node.light_count == a.light_count + b.light_count);
  }
}

RC_GTEST_PROP(Build, TakesTheRepresentativeOfOneChildAndNeverABlackOne, ()) {
  const LightSet lights = (*gen::scene(60)).light_set();
  const LightTree tree = build(lights, {*rc::gen::arbitrary<std::uint64_t>(), any_builder()});
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const TreeNode& node = tree.node(i);
    const std::uint32_t chosen = node.representative;
    if (node.intensity != glm::dvec3(0)) RC_ASSERT(lights[chosen].intensity != glm::vec3(0));
    if (node.is_leaf()) continue;
    // One, not both: no light is in two clusters.
    RC_ASSERT((chosen == tree.node(node.first_child).representative) !=
              (chosen == tree.node(node.first_child + 1).representative));
  }
}

RC_GTEST_PROP(Build, DependsOnTheSeedForRepresentativesOnly, ()) {
  const LightSet lights = (*gen::scene(40)).light_set();
  const Builder builder = any_builder();
  const LightTree a = build(lights, {*rc::gen::arbitrary<std::uint64_t>(), builder});
  const LightTree b = build(lights, {*rc::gen::arbitrary<std::uint64_t>(), builder});
  for (std::uint32_t i = 0; i < a.nodes().size(); ++i) {
    RC_ASSERT(a.node(i).box == b.node(i).box);
    RC_ASSERT(a.node(i).first_child == b.node(i).first_child);
  }
}

// Each count is binomial over the seeds. By Bernstein's inequality, a deviation of z standard
// deviations + z^2/3 has probability below 2 exp(-z^2/2): 5e-8 at z = 5.92, 5e-7 for 10 lights.
// Power: a choice that ignores intensity is off by 1/10 - 10/55 of the seeds, 26 deviations here.
TEST(Build, ChoosesRepresentativesInProportionToIntensity) {
  constexpr int seeds = 20000;
  constexpr double z = 5.92;
  LightSet lights;
  for (int i = 0; i < 10; ++i) lights.add_omni({i * i, i % 3, 0}, glm::vec3(float(i + 1)));
  std::vector<int> chosen(10);
  for (int seed = 0; seed < seeds; ++seed)
    ++chosen[build(lights, {static_cast<std::uint64_t>(seed)}).node(0).representative];
  for (int i = 0; i < 10; ++i) {
    const double p = (i + 1) / 55.0;
    EXPECT_LE(std::abs(chosen[i] - seeds * p), z * std::sqrt(seeds * p * (1 - p)) + z * z / 3);
  }
}

TEST(Build, EndsSoonOnceItIsCancelled) {
  LightSet lights;
  gen::Dice dice(7);
  for (int i = 0; i < 10000; ++i) lights.add_omni(dice.in_cube(), glm::vec3(1));
  for (const Builder builder : all_builders) {
    int asked = 0;
    const auto third = Progress::until([&asked] { return ++asked == 3; });
    EXPECT_THROW((void)build(lights, {1, builder, third}), Cancelled);
    EXPECT_EQ(asked, 3);
    const auto at_once = Progress::until([] { return true; });
    EXPECT_THROW((void)build(lights, {1, builder, at_once}), Cancelled);
    const auto never = Progress::until([] { return false; });
    EXPECT_EQ(build(lights, {1, builder, never}).nodes().size(), 19999U);
  }
}

TEST(Build, OfNoLightsIsEmpty) {
  for (const Builder builder : all_builders) EXPECT_TRUE(build({}, {1, builder}).empty());
}

TEST(Build, KnowsItsBuildersByName) {
  for (const Builder builder : all_builders)
    EXPECT_EQ(value_named<Builder>(name_of(builder)), builder);
  EXPECT_FALSE(value_named<Builder>("Greedy"));
}

TEST(Build, OfAHundredThousandLightsIsQuick) {
  LightSet lights;
  gen::Dice dice(7);
  for (int i = 0; i < 100000; ++i) lights.add_omni(dice.in_cube(), glm::vec3(1));
  for (const Builder builder : all_builders) {
    const auto start = Clock::now();
    const LightTree tree = build(lights, {1, builder});
    const double seconds = seconds_since(start);
    // Told, not judged: machines differ.
    std::cout << "100000 lights, " << name_of(builder) << ": " << seconds << " s\n";
    EXPECT_EQ(tree.node(0).light_count, 100000U);
  }
}

} // namespace
} // namespace lightcuts
