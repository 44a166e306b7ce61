// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightcuts {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(StressCommand, PrintsATableOfAllProperties) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"stress", "--cases", "200"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("lightcuts: 200 random cases of seed 1"));
  EXPECT_THAT(outcome.out, HasSubstr("translation-is-immaterial"));
  EXPECT_THAT(outcome.out, HasSubstr("All properties hold."));
  EXPECT_TRUE(oracle.files().empty());
}

TEST(StressCommand, PrintsTheSameTableByAnyNumberOfThreads) {
  const auto table = [](const std::string& threads) {
    const std::string out =
        OracleProcess().run({"stress", "--threads", threads, "--cases", "150"}).out;
    return out.substr(std::min(out.size(), out.find("\nproperty"))); // the first line has the time
  };
  EXPECT_THAT(table("1"), HasSubstr("All properties hold."));
  EXPECT_EQ(table("3"), table("1"));
  EXPECT_EQ(table("0"), table("1"));
}

TEST(StressCommand, SavesWhatItFindsAndSaysHowToFindItAgain) {
  const OracleProcess oracle;
  const Outcome outcome =
      oracle.run({"stress", "--subject", "heap-inverted", "--seed", "7", "--cases", "1e3"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("cut-obeys-threshold does not hold on "));
  const std::string file = "out/stress/counterexample-cut-obeys-threshold.json";
  EXPECT_THAT(outcome.out, HasSubstr("lightcuts-oracle replay " + file));
  EXPECT_THAT(outcome.out,
              HasSubstr("lightcuts-oracle stress --subject mutant:heap-inverted --seed 7 --cases"));
  const json saved = json::parse(content_of(oracle.folder() / file));
  EXPECT_EQ(saved["schema"], "lightcuts-oracle/counterexample/1");
  EXPECT_LE(saved["case"]["lights"].size(), 6U);
}

TEST(StressCommand, QuotesNamesThatAShellWouldSplit) {
  const Outcome outcome = OracleProcess().run(
      {"stress", "--subject", "heap-inverted", "--cases", "1e3", "--out", "it's here"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("lightcuts-oracle replay 'it'\\''s here/counterexample-"));
}

TEST(StressCommand, PrintsJsonAndNothingElse) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"stress", "--subject", "mutant:intensity-of-representative",
                                      "--cases", "100", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/stress/1");
  EXPECT_EQ(result["subject"], "mutant:intensity-of-representative");
  EXPECT_GT(result["violations"], 0);
  EXPECT_EQ(result["counterexample"]["lights"], 2);
  EXPECT_EQ(result["counterexample"]["views"], 1);
  const std::string file = result["counterexample"]["file"];
  EXPECT_TRUE(std::filesystem::exists(oracle.folder() / file));
}

TEST(StressCommand, HasEitherNamedCasesOrRandomOnes) {
  EXPECT_EQ(OracleProcess().run({"stress", "--catalogue", "--cases", "5"}).exit_code, 2);
  EXPECT_EQ(OracleProcess().run({"stress", "--catalogue", "--threads", "2"}).exit_code, 2);
}

TEST(StressCommand, RefusesUnknownSubjectsAndFolders) {
  const OracleProcess oracle;
  const Outcome unknown = oracle.run({"stress", "--subject", "nobody"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("'nobody' is unknown"));
  const Outcome unwritable =
      oracle.run({"stress", "--subject", "heap-inverted", "--out", "/dev/null/x"});
  EXPECT_EQ(unwritable.exit_code, 3);
  EXPECT_THAT(unwritable.err, HasSubstr("/dev/null/x"));
  EXPECT_EQ(oracle.run({"stress", "--cases", "0"}).exit_code, 2);
}

TEST(CheckCommandOnAMutant, SavesACounterexampleBesideTheScenesResults) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"check", "cloud?lights=20", "--size", "16x12", "--cases",
                                      "2000", "--subject", "mutant:intensity-of-representative"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("replay it:\n  lightcuts-oracle replay "));
  const auto files = oracle.files();
  ASSERT_EQ(std::count_if(files.begin(), files.end(),
                          [](const std::string& f) { return f.ends_with(".json"); }),
            1);
  const auto file = std::find_if(files.begin(), files.end(),
                                 [](const std::string& f) { return f.ends_with(".json"); });
  EXPECT_EQ(oracle.run({"replay", *file}).exit_code, 1);
  EXPECT_EQ(oracle.run({"replay", *file, "--subject", "lightcuts"}).exit_code, 0);
}

} // namespace
} // namespace lightcuts
