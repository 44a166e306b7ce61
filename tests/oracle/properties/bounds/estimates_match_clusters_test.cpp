// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/mutants/mutants.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr auto estimates = Property::estimates_match_clusters;

/// A lattice of lights, far enough away for one to be about as good as all.
Case lattice(int side) {
  Case c;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      c.lights.push_back({.position = {x, y, 60}, .intensity = glm::vec3(1)});
  c.views.resize(1);
  return c;
}

PropertyCount judged(const Subject& subject, const Case& on) {
  Tally tally;
  check_case(subject, on, 0, tally, estimates);
  return tally[estimates];
}

TEST(EstimatesMatchClusters, HoldsForTheLibraryAndForRepresentatives) {
  for (const auto& subject : {library_subject(), paper_subject()}) {
    const PropertyCount count = judged(*subject, lattice(8));
    EXPECT_EQ(count.cases, 1U);
    EXPECT_EQ(count.violations, 0U) << count.first_violation;
  }
}

TEST(EstimatesMatchClusters, IsBrokenByOneOfHalfTheLights) {
  const PropertyCount count = judged(*mutant_named("estimate-of-half")->subject(), lattice(8));
  EXPECT_EQ(count.violations, 1U);
  EXPECT_EQ(count.severity, Severity::waste);
  EXPECT_THAT(count.first_violation, testing::HasSubstr("in the mean"));
}

// Of so few clusters no mean is made.
TEST(EstimatesMatchClusters, IsNotAskedOfAFewLights) {
  EXPECT_EQ(judged(*library_subject(), lattice(1)).cases, 0U);
  EXPECT_EQ(judged(*library_subject(), lattice(6)).cases, 0U);
}

} // namespace
} // namespace lightcuts::oracle
