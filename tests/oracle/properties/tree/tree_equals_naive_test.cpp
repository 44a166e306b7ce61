// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <oracle/truth/naive_tree.h>
#include <tests/oracle/support/judged_point.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;

constexpr std::size_t most_of_naive = 12;

Tally cost_of(const LightTree& tree) {
  Tally tally;
  (void)Judge(only(Part::greedy_tree), 0, tally, Property::tree_equals_naive)
      .tree(claim_of(tree), tree.lights());
  return tally;
}

LightTree dearest_tree(const LightSet& lights) {
  return naive_tree(lights, [](const auto& a, const auto& b) { return -greedy_metric(a, b); });
}

LightSet row(std::size_t count) {
  LightSet lights;
  for (std::size_t i = 0; i < count; ++i) lights.add_omni({i * i, 0, 1}, glm::vec3(1));
  return lights;
}

RC_GTEST_PROP(TreeEqualsNaive, HoldsForTheLibrary, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, int(most_of_naive))).light_set();
  RC_ASSERT(violated(cost_of(build(lights))).empty());
}

TEST(TreeEqualsNaive, ConvictsATreeThatMergesTheFarthestFirst) {
  for (const std::size_t count : {3, 6, 12}) {
    const Tally tally = cost_of(dearest_tree(row(count)));
    EXPECT_THAT(violated(tally), ElementsAre(Property::tree_equals_naive));
    EXPECT_GT(tally[Property::tree_equals_naive].worst_ratio, 1);
  }
}

// The second merge may be any of two; the one that the definition rules out costs a little more.
TEST(TreeEqualsNaive, ConvictsATreeThatIsOneMergeOff) {
  LightSet lights;
  for (const float x : {0.0F, 1.0F, 2.001F}) lights.add_omni({x, 0, 0}, glm::vec3(1));
  EXPECT_THAT(violated(cost_of(naive_tree(lights,
                                          [](const auto& a, const auto& b) {
                                            return a.first == 1 && b.first == 2
                                                       ? 0
                                                       : greedy_metric(a, b);
                                          }))),
              ElementsAre(Property::tree_equals_naive));
}

TEST(TreeEqualsNaive, IsNotAskedOfManyLightsNorOfSeveralKinds) {
  constexpr auto p = Property::tree_equals_naive;
  EXPECT_EQ(cost_of(build(row(most_of_naive)))[p].cases, 1U);
  EXPECT_EQ(cost_of(build(row(most_of_naive + 1)))[p].cases, 0U);
  LightSet two_kinds = row(2);
  two_kinds.add_directional({0, 0, 1}, glm::vec3(1));
  EXPECT_EQ(cost_of(build(two_kinds))[p].cases, 0U);
}

} // namespace
} // namespace lightcuts::oracle
