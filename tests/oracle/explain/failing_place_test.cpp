// SPDX-License-Identifier: MIT
#include <oracle/explain/failing_place.h>

#include <gtest/gtest.h>
#include <oracle/counterexamples/named_subjects.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

Counterexample found_in(const std::string& mutant, Property property) {
  HuntResult result = hunt(*subject_named(mutant), {.cases = 20'000});
  EXPECT_TRUE(result.found);
  result.found->property = property;
  return *result.found;
}

TEST(FailingPlace, IsTheFirstClusterWhoseBoundIsTooLow) {
  const auto subject = subject_named("mutant:intensity-of-representative");
  const Counterexample c = shrunk(*subject, found_in("mutant:intensity-of-representative",
                                                     Property::bound_dominates_contribution));
  const auto place = failing_place(*subject, c);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->view, 0U);
  EXPECT_EQ(place->node, 0U); // of two lights the root is the only cluster that is no light
  EXPECT_FALSE(failing_place(*subject_named("lightcuts"), c));
}

TEST(FailingPlace, IsAPointWithoutAClusterForCuts) {
  const auto subject = subject_named("mutant:capacity-off-by-one");
  Counterexample c = found_in("mutant:capacity-off-by-one", Property::cut_obeys_threshold);
  // The view before it is a point that is dark, where all holds.
  CaseView dark = c.on.views.front();
  dark.view.material = Material{};
  c.on.views.insert(c.on.views.begin(), dark);
  const auto place = failing_place(*subject, c);
  ASSERT_TRUE(place);
  EXPECT_GE(place->view, 1U);
  EXPECT_FALSE(place->node);
  // One of too many clusters: not an exact one, which may have all.
  const auto cuts = cuts_of(c.on.cut, c.on.lights.size());
  EXPECT_TRUE(place->cut == cuts[0] || place->cut == cuts[2]);
}

} // namespace
} // namespace lightcuts::oracle
