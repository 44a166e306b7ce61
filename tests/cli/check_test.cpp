// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <csignal>
#include <fstream>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <tests/cli/terminal.h>

namespace lightcuts {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsSupersetOf;

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> list;
  for (const auto& [key, value] : object.items()) list.push_back(key);
  return list;
}

const std::vector<std::string> small_check{"check", "cloud?lights=20", "--size",
                                           "16x12", "--cases",         "2000"};

TEST(CheckCommand, PrintsATableOfAllProperties) {
  const Outcome outcome = OracleProcess().run(small_check);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("bound-dominates-contribution"));
  EXPECT_THAT(outcome.out, HasSubstr("occlusion-equals-brute-force"));
  EXPECT_THAT(outcome.out, HasSubstr("All properties hold."));
}

TEST(CheckCommand, PrintsJsonAndNothingElse) {
  const OracleProcess oracle;
  const Outcome outcome =
      oracle.run(with(small_check, {"--seed", "5", "--threshold", "4%", "--json", "-"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json result = json::parse(outcome.out);
  EXPECT_THAT(keys(result), IsSupersetOf({"schema", "scene", "seed", "threshold", "properties",
                                          "violations", "seconds"}));
  EXPECT_EQ(result["schema"], "lightcuts-oracle/check/1");
  EXPECT_EQ(result["scene"], "cloud?lights=20");
  EXPECT_EQ(result["seed"], 5);
  EXPECT_EQ(result["threshold"], 0.04);
  EXPECT_EQ(result["violations"], 0);
  EXPECT_GT(result["seconds"], 0);
  int reached = 0; // the others need triangles of a case, or its few lights to be of one kind
  for (const json& property : result["properties"]) {
    EXPECT_EQ(keys(property),
              (std::vector<std::string>{"cases", "name", "violations", "worst_ratio"}));
    reached += property["cases"] > 0 ? 1 : 0;
    EXPECT_EQ(property["violations"], 0);
    EXPECT_TRUE(property["worst_ratio"].is_null() || property["worst_ratio"] <= 1);
  }
  EXPECT_EQ(result["properties"][0]["name"], "tree-partitions-lights");
  EXPECT_EQ(reached, 37);
  EXPECT_TRUE(oracle.files().empty());
}

TEST(CheckCommand, WritesJsonToTheFolderAskedFor) {
  const OracleProcess oracle;
  EXPECT_EQ(oracle.run(with(small_check, {"--out", "results"})).exit_code, 0);
  std::ifstream file(oracle.folder() / "results" / "check.json");
  EXPECT_EQ(json::parse(file)["schema"], "lightcuts-oracle/check/1");
  const Outcome refused = oracle.run(with(small_check, {"--out", "/dev/null/x"}));
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, testing::HasSubstr("/dev/null/x"));
}

TEST(CheckCommand, WritesJsonToAFileBesideTheTable) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run(with(small_check, {"--json", "a b.json"}));
  EXPECT_THAT(outcome.out, HasSubstr("All properties hold."));
  EXPECT_EQ(json::parse(content_of(oracle.folder() / "a b.json"))["violations"], 0);
  EXPECT_EQ(oracle.files().size(), 1U);
}

TEST(CheckCommand, CountsTheSameForAnyNumberOfThreads) {
  const OracleProcess oracle;
  json one = json::parse(oracle.run(with(small_check, {"--threads", "1", "--json", "-"})).out);
  json two = json::parse(oracle.run(with(small_check, {"--threads", "2", "--json", "-"})).out);
  for (json* result : {&one, &two})
    for (const char* timed : {"seconds", "swept_pairs_per_second"}) result->erase(timed);
  EXPECT_EQ(one, two);
}

TEST(CheckCommand, TakesCasesAsPowersOfTen) {
  const OracleProcess oracle;
  const auto cases = [&](const char* number) {
    return json::parse(
        oracle
            .run({"check", "cloud?lights=20", "--size", "16x12", "--cases", number, "--json", "-"})
            .out)["pairs"];
  };
  EXPECT_GE(cases("3e3"), 3000);
  EXPECT_LT(cases("3e3"), 3000 + 39);
  EXPECT_EQ(cases("3000"), cases("3e3"));
}

TEST(CheckCommand, HoldsAtThresholdZero) {
  EXPECT_EQ(OracleProcess().run(with(small_check, {"--threshold", "0"})).exit_code, 0);
}

// Two of them, and what they leave: all are judged by oracle_test.
TEST(MutantsCommand, TellsHowThoseNamedWereCaught) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"mutants", "heap-inverted", "slab-is-inside", "--cases",
                                      "400", "--json", "-", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json result = json::parse(outcome.out);
  EXPECT_EQ(keys(result), (std::vector<std::string>{"caught", "library", "library_passes",
                                                    "mutants", "schema", "total"}));
  EXPECT_EQ(result["library_passes"], true);
  EXPECT_EQ(result["library"]["cases"], 400);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/mutants/2");
  EXPECT_EQ(result["caught"], 2);
  EXPECT_EQ(result["total"], 2);
  const json& inverted = result["mutants"][0];
  EXPECT_EQ(inverted["name"], "heap-inverted");
  EXPECT_EQ(inverted["property"], "cut-obeys-threshold");
  EXPECT_EQ(inverted["severity"], "violation");
  EXPECT_LE(inverted["lights"], 8);
  EXPECT_EQ(inverted["points"], 1);
  EXPECT_EQ(result["mutants"][1]["severity"], "waste");
  EXPECT_EQ(json::parse(content_of(oracle.folder() / "results" / "mutants.json"))["caught"], 2);
  const Outcome replayed = oracle.run({"replay", "results/counterexample-heap-inverted.json"});
  EXPECT_EQ(replayed.exit_code, 1);
  EXPECT_THAT(replayed.out, HasSubstr("heap-inverted"));
}

// The third case is the first with which it does anything wrong.
TEST(MutantsCommand, FailsWhereTheyEscape) {
  const Outcome outcome = OracleProcess().run({"mutants", "last-row", "--cases", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("\n0 of 1 caught"));
}

TEST(MutantsCommand, RefusesANameThatNoneHas) {
  const Outcome outcome = OracleProcess().run({"mutants", "heap-invertd"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("'heap-invertd'"));
}

/// The counts in a JSON result, without what differs from run to run.
json counts_of(const Outcome& outcome) {
  json result = json::parse(outcome.out);
  for (const char* timed : {"seconds", "swept_pairs_per_second"}) result.erase(timed);
  return result;
}

TEST(Campaign, GoesOnFromItsFile) {
  const OracleProcess oracle;
  const std::vector<std::string> base{
      "check", "cloud?lights=20&blocks=0", "--size", "16x12", "--json", "-"};
  const json whole = counts_of(oracle.run(with(base, {"--cases", "20000"})));
  const std::vector<std::string> kept = with(base, {"--resume", "kept.json"});
  EXPECT_EQ(oracle.run(with(kept, {"--cases", "2000"})).exit_code, 0);
  EXPECT_EQ(counts_of(oracle.run(with(kept, {"--cases", "20000", "--threads", "1"}))), whole);
  // Nothing is left to do.
  EXPECT_EQ(counts_of(oracle.run(with(kept, {"--cases", "20000"}))), whole);
}

TEST(Campaign, RefusesTheFileOfAnother) {
  const OracleProcess oracle;
  const std::vector<std::string> kept = with(small_check, {"--resume", "kept.json"});
  EXPECT_EQ(oracle.run(kept).exit_code, 0);
  const Outcome other = oracle.run(with(kept, {"--seed", "9"}));
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("seed 1, not 9"));
  const Outcome clamped = oracle.run(with(kept, {"--min-distance", "0.5"}));
  EXPECT_EQ(clamped.exit_code, 3);
  EXPECT_THAT(clamped.err, HasSubstr("hash of the lights"));
  std::ofstream(oracle.folder() / "kept.json") << R"({"schema": "lightcuts-oracle/campaign/0"})";
  const Outcome old = oracle.run(kept);
  EXPECT_EQ(old.exit_code, 3);
  EXPECT_THAT(old.err, HasSubstr("kept.json: is of another version of lightcuts-oracle"));
  std::ofstream(oracle.folder() / "kept.json") << "{\"schema\": 3";
  EXPECT_EQ(oracle.run(kept).exit_code, 3);
  EXPECT_EQ(oracle.run(with(small_check, {"--resume", "/dev/null/x"})).exit_code, 3);
  // A pipe that nobody writes to never ends.
  ASSERT_EQ(mkfifo((oracle.folder() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(oracle.run(with(small_check, {"--resume", "pipe"})).exit_code, 3);
}

TEST(Campaign, IsSavedAtCtrlC) {
  const OracleProcess oracle;
  const Terminal terminal;
  const auto out = oracle.folder() / "out.json";
  const pid_t child = oracle.start({"check", "cloud?lights=100", "--size", "16x12", "--cases",
                                    "1e12", "--resume", "kept.json", "--json", "-"},
                                   out, terminal.path());
  ASSERT_THAT(terminal.next(), HasSubstr("check cloud?lights=100 [")); // it is at work
  kill(child, SIGINT);
  const Outcome outcome = OracleProcess::outcome_of(child, out, terminal.path());
  EXPECT_EQ(outcome.exit_code, 0);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["complete"], false);
  EXPECT_GT(result["pairs"], 0);
  const json kept = json::parse(content_of(oracle.folder() / "kept.json"));
  EXPECT_EQ(kept["result"]["pairs"], result["pairs"]);
}

TEST(Campaign, EndsInTime) {
  const Outcome outcome = OracleProcess().run({"check", "cloud?lights=100", "--size", "16x12",
                                               "--cases", "1e12", "--time", "1s", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["complete"], false);
  EXPECT_GT(result["pairs"], 0);
  EXPECT_LT(result["seconds"], 20);
  EXPECT_EQ(OracleProcess().run({"check", "desk", "--time", "soon"}).exit_code, 2);
}

} // namespace
} // namespace lightcuts
