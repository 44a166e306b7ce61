// SPDX-License-Identifier: MIT
#include <oracle/mutants/mutants.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <oracle/campaign/hunt.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

// Every 500th is judged by many draws.
constexpr std::uint64_t enough_cases = 10'000;

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

// What is valid, if dear, is no violation.
TEST(Mutants, ThatAreWastefulOnlyAreNotCalledWrong) {
  for (const char* name : {"slab-is-inside", "metric-ignores-intensity", "metric-difference"}) {
    HuntConfig config;
    config.cases = 2000;
    config.waste = false;
    const HuntResult result = hunt(*mutant_named(name)->subject(), config);
    EXPECT_FALSE(result.found) << name << ": " << result.found->message;
    EXPECT_GT(result.tally.wasteful(), 0U) << name;
  }
}

/// Whether the property does not hold on the case once it was written to a file and read from it.
bool fails_when_replayed(const Subject& subject, const Counterexample& found) {
  const std::string text = counterexample_json({subject.name(), found});
  const Counterexample read = read_counterexample("a.json", text).counterexample;
  Tally tally;
  check_case(subject, read.on, 0, tally);
  return tally[read.property].violations > 0;
}

// Two lights and one point at the median, eight lights at most.
TEST(Mutants, ShrinkToLittleThatFailsWhenReplayed) {
  std::vector<std::size_t> lights;
  for (const Mutant& mutant : mutants()) {
    const auto subject = mutant.subject();
    HuntConfig config;
    config.cases = enough_cases;
    config.further = 100;
    const HuntResult result = hunt(*subject, config);
    ASSERT_TRUE(result.found) << mutant.name;
    const Counterexample small = shrunk(*subject, *result.found);
    lights.push_back(small.on.lights.size());
    EXPECT_LE(lights.back(), 8U) << mutant.name;
    EXPECT_LE(small.on.views.size(), 2U) << mutant.name;
    EXPECT_TRUE(fails_when_replayed(*subject, small)) << mutant.name;
  }
  std::sort(lights.begin(), lights.end());
  EXPECT_LE(lights[lights.size() / 2], 2U);
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
  EXPECT_GE(names.size(), 60U);
}

TEST(MutantNamed, KnowsNoOther) {
  EXPECT_EQ(mutant_named("lightcuts"), nullptr);
  EXPECT_EQ(mutant_named(""), nullptr);
}

} // namespace
} // namespace lightcuts::oracle
