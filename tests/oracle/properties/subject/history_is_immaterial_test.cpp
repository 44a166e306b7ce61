// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/campaign/hunt.h>
#include <oracle/mutants/mutants.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr auto history = Property::history_is_immaterial;

/// Five lights, and two views of them from different sides.
Case aged_case(std::uint32_t builds, std::uint32_t questions) {
  Case c;
  for (int i = 0; i < 5; ++i)
    c.lights.push_back({.position = {float(i) - 1.5F, 0.5F * float(i % 2), 1 + 0.25F * float(i)},
                        .intensity = glm::vec3(1)});
  c.views.resize(2);
  c.views[1].view.position = {0.5F, 0.25F, -1};
  c.builds = builds;
  c.questions = questions;
  return c;
}

PropertyCount judged(const Subject& subject, const Case& on) {
  Tally tally;
  check_case(subject, on, 0, tally, history);
  return tally[history];
}

TEST(HistoryIsImmaterial, HoldsForTheLibrary) {
  for (const auto& [builds, questions] : {std::pair(0, 1), {3, 0}, {2, 257}, {0, 70'000}}) {
    const PropertyCount count = judged(*library_subject(), aged_case(builds, questions));
    EXPECT_EQ(count.cases, 1U);
    EXPECT_EQ(count.violations, 0U) << count.first_violation;
  }
}

TEST(HistoryIsImmaterial, IsNotAskedWithoutAHistory) {
  EXPECT_EQ(judged(*library_subject(), aged_case(0, 0)).cases, 0U);
  Case one_view = aged_case(0, 10);
  one_view.views.pop_back();
  EXPECT_EQ(judged(*library_subject(), one_view).cases, 0U);
}

// A stamp wraps after exactly so many questions, and after no other number.
TEST(HistoryIsImmaterial, IsBrokenByStampsThatWrap) {
  const auto narrow = mutant_named("stamp-of-8-bits")->subject();
  EXPECT_EQ(judged(*narrow, aged_case(0, 256)).violations, 1U);
  EXPECT_EQ(judged(*narrow, aged_case(0, 255)).violations, 0U);
  const auto wide = mutant_named("stamp-of-16-bits")->subject();
  EXPECT_EQ(judged(*wide, aged_case(0, 1U << 16)).violations, 1U);
  EXPECT_EQ(judged(*wide, aged_case(0, 256)).violations, 0U);
}

TEST(HistoryIsImmaterial, IsBrokenByWhatStaysFromTheBuildBefore) {
  const auto keeps = mutant_named("tree-of-lights-before")->subject();
  const PropertyCount count = judged(*keeps, aged_case(1, 0));
  EXPECT_EQ(count.violations, 1U);
  EXPECT_THAT(count.first_violation, testing::HasSubstr("after 1 builds of as many other lights"));
  EXPECT_EQ(judged(*keeps, aged_case(0, 5)).violations, 0U);
}

TEST(HistoryIsImmaterial, ShrinksToTheShortestHistory) {
  const auto wide = mutant_named("stamp-of-16-bits")->subject();
  const Case on = aged_case(2, 1U << 17);
  const auto message = failure_of(*wide, history, on);
  ASSERT_TRUE(message);
  const Counterexample small = shrunk(*wide, {history, on, *message, 0}, 60);
  EXPECT_EQ(small.on.questions, 1U << 16);
  EXPECT_EQ(small.on.builds, 0U);
}

} // namespace
} // namespace lightcuts::oracle
