// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/as_test.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/oracle/support/all_features_case.h>

namespace lightcuts::oracle {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Without the first line, and what clang-format may change.
std::string essence(std::istream& in, bool skip_first_line) {
  std::string line, text;
  if (skip_first_line) std::getline(in, line);
  while (std::getline(in, line)) text += line;
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

// as_test_example_test.cpp, which is compiled and run with the others.
TEST(AsTest, PrintsATestThatCompiles) {
  const SavedCounterexample saved{
      "mutant:intensity-of-representative",
      {Property::bound_dominates_contribution, all_features_case(), "", 0}};
  std::ifstream example(LIGHTCUTS_AS_TEST_EXAMPLE);
  ASSERT_TRUE(example);
  std::istringstream printed(as_test(saved));
  EXPECT_EQ(essence(printed, false), essence(example, true));
}

TEST(AsTest, JudgesTheSubjectOfTheFile) {
  const auto text = [](const char* subject) {
    return as_test({subject, {Property::threads_agree, all_features_case(), "", 0}});
  };
  EXPECT_THAT(text("lightcuts"), HasSubstr("failure_of(*library_subject()"));
  EXPECT_THAT(text("paper"), HasSubstr("failure_of(*paper_subject()"));
  EXPECT_THAT(text("locally-ordered"), HasSubstr("failure_of(*locally_ordered_subject()"));
  EXPECT_THAT(text("stochastic-intensity"),
              HasSubstr("failure_of(*stochastic_intensity_subject()"));
  EXPECT_THAT(text("lightcuts"), Not(HasSubstr("EXPECT_NE")));
  EXPECT_THAT(text("mutant:heap-inverted"), HasSubstr("TEST(HeapInverted, ThreadsAgree)"));
}

} // namespace
} // namespace lightcuts::oracle
