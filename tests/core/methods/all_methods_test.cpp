// SPDX-License-Identifier: MIT
#include <lightcuts/core/methods/all_methods.h>

#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tests/support/readme.h>

namespace lightcuts {
namespace {

TEST(AllMethods, AreFoundByNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Method method : all_methods) {
    EXPECT_EQ(method_named(method->name), method);
    names.insert(method->name);
  }
  EXPECT_EQ(names.size(), std::size(all_methods));
  EXPECT_FALSE(method_named("none"));
}

TEST(AllMethods, SayWhatTheyMeanInOneSentence) {
  for (const Method method : all_methods) {
    const std::string meaning = method->meaning;
    ASSERT_FALSE(meaning.empty()) << method->name;
    EXPECT_EQ(meaning.find('.'), meaning.size() - 1) << method->name;
  }
}

TEST(AllMethods, StandInTheReadmesTableInTheirOrder) {
  std::string table;
  for (const Method method : all_methods)
    table += fmt::format("| `{}` | {} |\n", method->name, method->meaning);
  EXPECT_NE(test::readme().find("|---|---|\n" + table + "\n"), std::string::npos)
      << "README.md should have:\n"
      << table;
}

} // namespace
} // namespace lightcuts
