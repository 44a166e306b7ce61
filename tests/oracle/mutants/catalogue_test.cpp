// SPDX-License-Identifier: MIT
#include <oracle/mutants/mutants.h>

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/readme.h>

namespace lightcuts::oracle {
namespace {

/// Names in the first column of the section's tables: what stands between "| `" and "` |".
std::vector<std::string> first_column(const std::string& section) {
  const std::string begin = "\n| `", end = "` |";
  std::vector<std::string> names;
  for (std::size_t at = section.find(begin); at != std::string::npos;
       at = section.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    names.push_back(section.substr(first, section.find(end, first) - first));
  }
  return names;
}

TEST(Mutants, StandInTheReadmesTableInTheirOrder) {
  const std::string section = test::readme_section("## Broken on purpose");
  std::vector<std::string> names;
  for (const Mutant& mutant : mutants()) names.emplace_back(mutant.name);
  EXPECT_THAT(first_column(section), testing::ElementsAreArray(names));
  EXPECT_THAT(section, testing::HasSubstr(fmt::format("judges {} deliberately", names.size())));
}

} // namespace
} // namespace lightcuts::oracle
