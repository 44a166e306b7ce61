// SPDX-License-Identifier: MIT
#include <oracle/truth/naive_tree.h>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

using testing::IsEmpty;

Topology topology_of(const LightTree& tree) {
  return read_topology(claim_of(tree), tree.lights().size()).topology.value();
}

LightSet lights_at(const std::vector<glm::vec3>& positions, float intensity = 1) {
  LightSet lights;
  for (const glm::vec3& p : positions) lights.add_omni(p, glm::vec3(intensity));
  return lights;
}

/// Indices of both children's lowest lights, of all clusters in the order of merging.
std::vector<std::pair<std::uint32_t, std::uint32_t>> merges(const LightSet& lights) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> list;
  const auto all = naive_clusters(lights);
  for (const NaiveCluster& c : all)
    if (c.children[0] >= 0)
      list.emplace_back(all[std::size_t(c.children[0])].first,
                        all[std::size_t(c.children[1])].first);
  return list;
}

TEST(NaiveTree, MergesTheCheapestPairEachTime) {
  using testing::ElementsAre;
  using testing::Pair;
  const LightSet lights = lights_at({{0, 0, 0}, {10, 0, 0}, {11, 0, 0}, {0, 3, 0}});
  EXPECT_THAT(merges(lights), ElementsAre(Pair(1, 2), Pair(0, 3), Pair(0, 1)));
}

TEST(NaiveTree, MergesTheLowestLightsAmongEquals) {
  using testing::ElementsAre;
  using testing::Pair;
  const LightSet lights = lights_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  EXPECT_THAT(merges(lights), ElementsAre(Pair(0, 1), Pair(2, 3), Pair(0, 2)));
}

// Dim ones first, though they are farther apart: 2 x 0.1 x 4 against 2 x 1 x 1, per channel.
TEST(NaiveTree, WeighsByIntensity) {
  LightSet lights = lights_at({{0, 0, 0}, {1, 0, 0}});
  for (const float y : {20.0F, 22.0F}) lights.add_omni({0, y, 0}, glm::vec3(0.1F));
  EXPECT_EQ(merges(lights).front(), std::pair(2U, 3U));
}

TEST(NaiveTree, KeepsOpposedLightsApart) {
  LightSet lights;
  for (const float x : {0.0F, 0.2F, 0.25F, 1.0F})
    lights.add_oriented({x, 0, 0}, {0, 0, x == 0.2F ? -1 : 1}, glm::vec3(1));
  EXPECT_EQ(merges(lights).front(), std::pair(0U, 2U));
}

TEST(NaiveTree, CostsTheSumOverItsClusters) {
  const LightSet lights = lights_at({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}}, 2);
  EXPECT_DOUBLE_EQ(naive_tree_cost(lights), 2 * 3 * (2 * 1 + 3 * 25));
  EXPECT_DOUBLE_EQ(tree_cost(topology_of(naive_tree(lights)), lights), naive_tree_cost(lights));
  EXPECT_EQ(naive_tree_cost(lights_at({{1, 2, 3}})), 0);
  EXPECT_EQ(naive_tree_cost(LightSet()), 0);
}

TEST(TreeCost, IsThatOfTheBoxesWhateverTheShape) {
  const LightSet lights = lights_at({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}});
  const TreeClaim one_leaf{{{.light_count = 3}}, {}, {1, 0, 2}};
  EXPECT_DOUBLE_EQ(tree_cost(*read_topology(one_leaf, 3).topology, lights), 3 * 3 * 25);
  // A worse one: the farthest pair first.
  const TreeClaim worse{{{.first_child = 0, .child_count = 2},
                         {.first_light = 0, .light_count = 1},
                         {.first_light = 1, .light_count = 2}},
                        {1, 2},
                        {1, 0, 2}};
  EXPECT_DOUBLE_EQ(tree_cost(*read_topology(worse, 3).topology, lights), 3 * (2 + 3) * 25);
}

RC_GTEST_PROP(NaiveTree, IsATreeOfTheLibraryAndCostsWhatItsDefinitionSays, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, 16)).light_set();
  const LightTree tree = naive_tree(lights);
  Tally tally;
  const auto topology = Judge(0, 0, tally).tree(claim_of(tree), lights);
  RC_ASSERT(violated(tally).empty());
  const double cost = naive_tree_cost(lights);
  if (!std::isfinite(cost)) return;
  RC_ASSERT(std::abs(tree_cost(*topology, lights) - cost) <= cost * 0x1p-40);
}

RC_GTEST_PROP(NaiveTree, CostsWhatTheLibrarysDoes, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, 16)).light_set();
  const double cost = naive_tree_cost(lights);
  if (!std::isfinite(cost)) return;
  RC_ASSERT(std::abs(tree_cost(topology_of(build(lights)), lights) - cost) <= cost * 0x1p-40);
}

TEST(NaiveTree, TakesAnotherMetric) {
  const LightSet lights = lights_at({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {6, 0, 0}});
  const LightTree farthest =
      naive_tree(lights, [](const auto& a, const auto& b) { return -greedy_metric(a, b); });
  Tally tally;
  const auto topology = Judge(0, 0, tally).tree(claim_of(farthest), lights);
  EXPECT_EQ(tally.violations(), 0U);
  EXPECT_GT(tree_cost(*topology, lights), naive_tree_cost(lights));
}

TEST(NaiveTree, GivesBoundsThatHold) {
  LightSet lights;
  for (int i = 0; i < 9; ++i) lights.add_omni({i % 3, i / 3, 1}, glm::vec3(1 + i));
  const JudgedPoint judged(
      naive_tree(lights, [](const auto& a, const auto& b) { return -greedy_metric(a, b); }),
      diffuse_point(), std::vector<char>(9, 1));
  LibraryTree tree = judged.library();
  Tally tally;
  Judge(library_parts, 0, tally).clusters(PointAnswers({tree, library_parts}, judged.at()));
  EXPECT_THAT(violated(tally), IsEmpty());
}

} // namespace
} // namespace lightcuts::oracle
