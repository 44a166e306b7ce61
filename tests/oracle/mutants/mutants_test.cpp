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
#include <lightcuts/core/jobs/seconds_since.h>
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

// What takes longer than this is left to the command `mutants`.
constexpr double enough_seconds = 5, enough_seconds_of_all = 150, enough_seconds_to_shrink = 150;
constexpr std::size_t fewest_judged = 20;

/// Of all, judged once: until something is found, and a little further.
const std::vector<Verdict>& verdicts() {
  static const std::vector<Verdict> all = [] {
    std::vector<Verdict> list;
    const auto start = Clock::now();
    for (const Mutant& mutant : mutants()) {
      if (seconds_since(start) > enough_seconds_of_all) break;
      HuntConfig config;
      config.cases = enough_cases;
      config.further = 20;
      config.seconds = enough_seconds;
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
  config.seconds = 60;
  std::size_t judged = 0;
  for (const Verdict& v : verdicts()) {
    if (!v.result.found) {
      EXPECT_GE(v.result.seconds, enough_seconds) << v.mutant.name;
      continue;
    }
    ++judged;
    config.cases = std::max(config.cases, v.result.cases);
  }
  EXPECT_GE(judged, fewest_judged);
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
  if (name == "estimate-of-another") return 64;
  return 8;
}

// Two lights and one point at the median, eight lights at most but where it takes more.
TEST(Mutants, ShrinkToLittleThatFailsWhenReplayed) {
  std::vector<std::size_t> lights;
  const auto start = Clock::now();
  for (const Verdict& v : verdicts()) {
    if (!v.result.found || seconds_since(start) > enough_seconds_to_shrink) continue;
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
