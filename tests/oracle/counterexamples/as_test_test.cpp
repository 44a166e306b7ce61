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
  const auto text = [](const std::string& subject) {
    return as_test({subject, {Property::threads_agree, all_features_case(), "", 0}});
  };
  for (const std::string name : {"lightcuts", "paper", "/of/some one/libmine.so"}) {
    EXPECT_THAT(text(name), HasSubstr("EXPECT_EQ(failure_of(*subject_named(\"" + name + "\"),"));
    EXPECT_THAT(text(name), HasSubstr("#include <oracle/counterexamples/named_subjects.h>"));
    EXPECT_THAT(text(name), Not(HasSubstr("EXPECT_NE")));
  }
  EXPECT_THAT(text("/a\\b\"c.so"), HasSubstr("subject_named(\"/a\\\\b\\\"c.so\")"));
  EXPECT_THAT(text("mutant:heap-inverted"), HasSubstr("TEST(HeapInverted, ThreadsAgree)"));
}

} // namespace
} // namespace lightcuts::oracle
