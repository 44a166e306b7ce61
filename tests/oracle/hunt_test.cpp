// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/hunt.h>

#include <gtest/gtest.h>
#include <lightcuts/oracle/check_case.h>
#include <lightcuts/oracle/library_subject.h>
#include <lightcuts/oracle/mutants.h>

namespace lightcuts::oracle {
namespace {

TEST(FailureOf, IsWhatCheckCaseSays) {
  for (const char* name : {"heap-inverted", "intensity-of-representative"}) {
    const auto subject = mutant_named(name)->subject();
    for (std::uint64_t index = 0; index < 100; ++index) {
      const Case on = random_case(11, index);
      Tally all;
      check_case(*subject, on, 0, all);
      for (std::size_t i = 0; i < property_count; ++i) {
        Tally one;
        check_case_for(Property(i), *subject, on, one);
        EXPECT_EQ(one[Property(i)].cases, all[Property(i)].cases) << info(Property(i)).name;
        EXPECT_EQ(one[Property(i)].violations, all[Property(i)].violations);
        EXPECT_EQ(one[Property(i)].first_violation, all[Property(i)].first_violation);
      }
    }
  }
}

TEST(Hunt, FindsTheSameAgain) {
  const auto subject = mutant_named("heap-inverted")->subject();
  const HuntResult once = hunt(*subject, {.seed = 5, .cases = 100});
  const HuntResult again = hunt(*subject, {.seed = 5, .cases = 100});
  ASSERT_TRUE(once.found && again.found);
  EXPECT_EQ(once.found->on, again.found->on);
  EXPECT_EQ(once.found->message, again.found->message);
  EXPECT_EQ(once.cases, once.found->index + 1);
  EXPECT_EQ(random_case(5, once.found->index), once.found->on);
}

TEST(Hunt, FindsNothingWrongWithTheLibrary) {
  const HuntResult result = hunt(*library_subject(), {.seed = 3, .cases = 300});
  EXPECT_FALSE(result.found) << result.found->message;
  EXPECT_EQ(result.cases, 300U);
}

TEST(Shrunk, IsSmallAndCannotBeSmaller) {
  const auto subject = mutant_named("intensity-of-representative")->subject();
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const HuntResult result = hunt(*subject, {.seed = seed, .cases = 100});
    ASSERT_TRUE(result.found);
    const Counterexample small = shrunk(*subject, *result.found, 100);
    EXPECT_EQ(small.property, result.found->property);
    EXPECT_EQ(small.on.lights.size(), 2U);
    EXPECT_EQ(small.on.views.size(), 1U);
    EXPECT_EQ(failure_of(*subject, small.property, small.on), small.message);
    for (const Case& simpler_one : simpler(small.on))
      EXPECT_FALSE(failure_of(*subject, small.property, simpler_one));
  }
}

} // namespace
} // namespace lightcuts::oracle
