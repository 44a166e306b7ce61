// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/catalogue.h>

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/campaign/catalogue_run.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/block_cuts_subject.h>
#include <oracle/subjects/library_subject.h>

#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {
namespace {

using testing::EndsWith;
using testing::IsEmpty;

TEST(Catalogue, HasFortyCasesWithNamesOfTheirOwnAndReasons) {
  std::set<std::string> names, reasons;
  for (const NamedCase& c : catalogue()) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_TRUE(reasons.insert(c.why).second) << c.why;
    EXPECT_THAT(c.why, EndsWith(".")) << c.name;
    EXPECT_EQ(named_case(c.name), &c);
  }
  EXPECT_GE(names.size(), 40U);
  EXPECT_EQ(named_case("easy"), nullptr);
}

TEST(Catalogue, IsMadeOfTheSameBitsEachTime) {
  for (const NamedCase& c : catalogue()) {
    if (c.is_large) continue;
    EXPECT_TRUE(complete(c) == complete(c)) << c.name;
  }
}

TEST(Catalogue, HasCasesThatNoneOfTheInnocentsBreaks) {
  for (const auto& subject :
       {library_subject(), locally_ordered_subject(), paper_subject(), block_cuts_subject()})
    for (const NamedCase& c : catalogue()) {
      if (c.is_large) continue;
      const NamedResult result = judge_named(*subject, c, 0);
      EXPECT_EQ(result.tally.violations(), 0U) << c.name;
      EXPECT_THAT(violated(result.tally), IsEmpty()) << subject->name() << ": " << c.name;
      // What zero-threshold-is-exact allows a cut; a light's own estimate errs less.
      EXPECT_LE(result.max_relative_error.value_or(0), 0x1p-23) << c.name;
      EXPECT_GT(result.checks, 0U) << c.name;
    }
}

TEST(Catalogue, ConvictsMutantsAndSaysWhere) {
  const NamedCase& face = *named_case("on-a-face");
  const NamedResult result = judge_named(*mutant_named("inside-is-finite")->subject(), face, 3);
  EXPECT_EQ(result.of, &face);
  EXPECT_THAT(violated(result.tally), testing::Contains(Property::bound_dominates_contribution));
  EXPECT_GT(result.worst_ratio, 1);
}

TEST(Catalogue, CountsWhatIsInfinite) {
  const auto library = library_subject();
  EXPECT_GT(judge_named(*library, *named_case("in-the-middle"), 0).saturated, 0U);
  EXPECT_EQ(judge_named(*library, *named_case("on-a-plane-above"), 0).saturated, 0U);
}

} // namespace
} // namespace lightcuts::oracle
