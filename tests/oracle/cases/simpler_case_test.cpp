// SPDX-License-Identifier: MIT
#include <oracle/cases/case.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/simpler_case.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/all_features_case.h>

namespace lightcuts::oracle {
namespace {

TEST(Case, IsEqualToItsCopyOnly) {
  const Case on = all_features_case();
  EXPECT_EQ(on, all_features_case());
  for (const Case& other : simpler(on)) EXPECT_FALSE(other == on);
}

TEST(Case, OfNothingHasNothingSimpler) {
  Case on;
  on.cut = {0.02F, 1000, 0};
  EXPECT_TRUE(simpler(on).empty());
}

// Else shrinking might go round in circles.
RC_GTEST_PROP(Case, GetsNoSimplerInTheEnd, (std::uint64_t seed, std::uint64_t index)) {
  Case on = random_case(seed, index);
  std::uint64_t dice = seed;
  bool found = true;
  int steps = 0;
  while (found) {
    RC_ASSERT(++steps < 5000);
    Case next;
    found = false;
    // Some candidates fail, as they would.
    visit_simpler(on, [&](Case& candidate) {
      dice = dice * 6364136223846793005U + 1442695040888963407U;
      next = candidate;
      return found = (dice >> 60) < 6;
    });
    if (found) on = next;
  }
}

TEST(Case, OfManyLightsIsHalvedFirst) {
  Case on = all_features_case();
  on.lights.resize(20'000, on.lights.front());
  on.views.front().hidden = {1, 9'999, 10'000, 19'999};
  int visited = 0;
  EXPECT_TRUE(visit_simpler(on, [&](Case& candidate) {
    EXPECT_EQ(candidate.lights.size(), 10'000U);
    EXPECT_EQ(candidate.views.front().hidden, visited == 0
                                                  ? (std::vector<std::uint32_t>{0, 9'999})
                                                  : (std::vector<std::uint32_t>{1, 9'999}));
    return ++visited == 2;
  }));
  EXPECT_EQ(visited, 2);
}

TEST(Case, KeepsItsIndicesOfLights) {
  const Case on = all_features_case();
  for (const Case& other : simpler(on))
    for (const CaseView& view : other.views)
      for (const std::uint32_t light : view.hidden) EXPECT_LT(light, other.lights.size());
}

} // namespace
} // namespace lightcuts::oracle
