// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/mutants.h>

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <lightcuts/oracle/hunt.h>
#include <lightcuts/oracle/library_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr std::uint64_t enough_cases = 2000;

/// Judged until something is found, which is soon for what is broken.
HuntResult hunted(const Subject& subject, std::uint64_t cases) {
  HuntConfig config;
  config.cases = cases;
  return hunt(subject, config);
}

TEST(Mutants, AreAllCaughtOnFewerCasesThanTheLibraryPasses) {
  std::uint64_t most = 0;
  for (const Mutant& mutant : mutants()) {
    const HuntResult result = hunted(*mutant.subject(), enough_cases);
    EXPECT_TRUE(result.found) << mutant.name;
    most = std::max(most, result.cases);
  }
  const HuntResult library = hunted(*library_subject(), most);
  EXPECT_FALSE(library.found) << info(library.found->property).name << ": "
                              << library.found->message;
}

TEST(Mutants, HaveNamesAndSayWhatIsWrong) {
  std::set<std::string> names;
  for (const Mutant& mutant : mutants()) {
    names.insert(mutant.name);
    EXPECT_EQ(mutant.subject()->name(), mutant.name);
    EXPECT_EQ(mutant_named(mutant.name), &mutant);
    EXPECT_GT(std::string(mutant.what_is_wrong).size(), 20U);
  }
  EXPECT_EQ(names.size(), mutants().size());
  EXPECT_GE(names.size(), 2U);
}

TEST(MutantNamed, KnowsNoOther) {
  EXPECT_EQ(mutant_named("lightcuts"), nullptr);
  EXPECT_EQ(mutant_named(""), nullptr);
}

} // namespace
} // namespace lightcuts::oracle
