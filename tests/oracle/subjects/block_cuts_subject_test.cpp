// SPDX-License-Identifier: MIT
#include <oracle/subjects/block_cuts_subject.h>

#include <gtest/gtest.h>
#include <oracle/campaign/hunt.h>
#include <oracle/counterexamples/named_subjects.h>

namespace lightcuts::oracle {
namespace {

TEST(BlockCutsSubject, HoldsInAThousandCases) {
  HuntConfig config;
  config.cases = 1000;
  config.seed = 41;
  const HuntResult result = hunt(*block_cuts_subject(), config);
  EXPECT_EQ(result.cases, 1000U);
  for (const Property p : all_properties)
    EXPECT_EQ(result.tally[p].violations, 0U)
        << info(p).name << ": " << result.tally[p].first_violation;
}

TEST(BlockCutsSubject, IsFoundByItsName) {
  EXPECT_EQ(subject_named("block-cuts", {})->name(), "block-cuts");
}

} // namespace
} // namespace lightcuts::oracle
