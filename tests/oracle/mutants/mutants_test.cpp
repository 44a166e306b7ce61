// SPDX-License-Identifier: MIT
#include <oracle/mutants/mutants.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
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

/// How a mutant fares.
struct Verdict {
  const Mutant& mutant;
  std::unique_ptr<Subject> subject;
  HuntResult result;
};

/// Of all, judged once: until something is found, and a little further.
const std::vector<Verdict>& verdicts() {
  static const std::vector<Verdict> all = [] {
    std::vector<Verdict> list;
    for (const Mutant& mutant : mutants()) {
      HuntConfig config;
      config.cases = enough_cases;
      config.further = 100;
      auto subject = mutant.subject();
      HuntResult result = hunt(*subject, config);
      list.push_back({mutant, std::move(subject), std::move(result)});
    }
    return list;
  }();
  return all;
}

TEST(Mutants, AreAllCaughtOnFewerCasesThanTheLibraryPasses) {
  HuntConfig config;
  config.cases = 0;
  for (const Verdict& v : verdicts()) {
    EXPECT_TRUE(v.result.found) << v.mutant.name;
    config.cases = std::max(config.cases, v.result.cases);
  }
  const HuntResult library = hunt(*library_subject(), config);
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

/// The most lights that it should take to show what is wrong.
std::size_t most_lights(std::string_view name) {
  if (name == "light-index-in-16-bits") return 65537;
  if (name == "last-of-1025-lights") return 1025;
  if (name == "stack-of-40-levels") return 50;
  if (name == "estimate-of-half") return 16385;
  if (name == "estimate-of-another" || name == "six-turns") return 64;
  return 8;
}

// Two lights and one point at the median, eight lights at most but where it takes more.
TEST(Mutants, ShrinkToLittleThatFailsWhenReplayed) {
  std::vector<std::size_t> lights;
  for (const Verdict& v : verdicts()) {
    ASSERT_TRUE(v.result.found) << v.mutant.name;
    const std::size_t most = most_lights(v.mutant.name);
    // What is as small as it can be already is not worth the time.
    const double seconds = v.result.found->on.lights.size() <= most && most > 1000 ? 0 : 10;
    const Counterexample small = shrunk(*v.subject, *v.result.found, seconds);
    lights.push_back(small.on.lights.size());
    EXPECT_LE(lights.back(), most) << v.mutant.name;
    EXPECT_LE(small.on.views.size(), 2U) << v.mutant.name;
    EXPECT_TRUE(fails_when_replayed(*v.subject, small)) << v.mutant.name;
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
  EXPECT_GE(names.size(), 80U);
}

TEST(MutantNamed, KnowsNoOther) {
  EXPECT_EQ(mutant_named("lightcuts"), nullptr);
  EXPECT_EQ(mutant_named(""), nullptr);
}

} // namespace
} // namespace lightcuts::oracle
