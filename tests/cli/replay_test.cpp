// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightcuts {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A folder with the counterexample of a mutant in it.
class ReplayCommand : public testing::Test {
protected:
  void SetUp() override {
    const Outcome outcome =
        oracle.run({"stress", "--subject", "mutant:intensity-of-representative", "--out", "."});
    ASSERT_EQ(outcome.exit_code, 1);
  }
  static constexpr const char* file = "counterexample-bound-dominates-contribution.json";
  OracleProcess oracle;
};

TEST_F(ReplayCommand, FailsWhileThePropertyDoesNotHold) {
  const Outcome outcome = oracle.run({"replay", file});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("truth, 700 bits"));
  EXPECT_THAT(outcome.out, HasSubstr("they part here: channel"));
  EXPECT_THAT(outcome.out, HasSubstr("is still violated by intensity-of-representative"));
  EXPECT_EQ(oracle.run({"replay", file}).out, outcome.out);
}

TEST_F(ReplayCommand, SucceedsOnceItHolds) {
  const Outcome outcome = oracle.run({"replay", file, "--subject", "lightcuts"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("It holds."));
  EXPECT_THAT(outcome.out, HasSubstr("holds for lightcuts on this case."));
}

TEST_F(ReplayCommand, PrintsJson) {
  const Outcome outcome = oracle.run({"replay", file, "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/replay/1");
  EXPECT_EQ(result["file"], file);
  EXPECT_EQ(result["subject"], "mutant:intensity-of-representative");
  EXPECT_EQ(result["property"], "bound-dominates-contribution");
  EXPECT_EQ(result["fails"], true);
  EXPECT_THAT(result["message"].get<std::string>(), HasSubstr("node 0"));
  EXPECT_TRUE(result["also_broken"].is_array());
}

TEST_F(ReplayCommand, PrintsATest) {
  const Outcome outcome = oracle.run({"replay", file, "--as-test"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out,
              HasSubstr("TEST(IntensityOfRepresentative, BoundDominatesContribution) {"));
}

// Found by many draws, the first two; the last is right, but dear.
TEST(Replay, FailsForWhatMutantsSaves) {
  const std::vector<std::string> names{"one-number-for-all", "resampled-between",
                                       "metric-difference"};
  const OracleProcess oracle;
  // At once: each command judges the library, too.
  const auto all = with(with({"mutants"}, names), {"--cases", "1000", "--out", "."});
  EXPECT_EQ(oracle.run(all).exit_code, 0);
  for (const std::string& name : names) {
    const Outcome outcome = oracle.run({"replay", "counterexample-" + name + ".json"});
    EXPECT_EQ(outcome.exit_code, 1) << name << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("is still violated by " + name));
  }
}

TEST_F(ReplayCommand, RefusesWhatItCannotRead) {
  const auto expect_refusal = [this](const std::vector<std::string>& arguments,
                                     const std::string& says) {
    const Outcome outcome = oracle.run(arguments);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr(says));
  };
  expect_refusal({"replay", "nowhere.json"}, "nowhere.json: cannot open");
  expect_refusal({"replay", file, "--subject", "mutant:nobody"}, "'mutant:nobody' is unknown");
  expect_refusal({"replay", file, "--json", "no/folder.json"}, "no/folder.json");
  std::ofstream(oracle.folder() / "bad.json") << "{\"schema\": 1}";
  expect_refusal({"replay", "bad.json"}, "bad.json: /schema is a number, expected a string");
  EXPECT_EQ(oracle.run({"replay"}).exit_code, 2);
}

} // namespace
} // namespace lightcuts
