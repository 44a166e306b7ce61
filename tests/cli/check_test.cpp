// SPDX-License-Identifier: MIT
#include "oracle_process.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

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
  int reached = 0; // the others need cases, not a scene
  for (const json& property : result["properties"]) {
    EXPECT_EQ(keys(property),
              (std::vector<std::string>{"cases", "name", "violations", "worst_ratio"}));
    reached += property["cases"] > 0 ? 1 : 0;
    EXPECT_EQ(property["violations"], 0);
    EXPECT_TRUE(property["worst_ratio"].is_null() || property["worst_ratio"] <= 1);
  }
  EXPECT_EQ(result["properties"][0]["name"], "tree-partitions-lights");
  EXPECT_EQ(reached, 17);
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
  one.erase("seconds");
  two.erase("seconds");
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

TEST(MutantsCommand, CatchesAllOfThem) {
  const Outcome outcome =
      OracleProcess().run({"mutants", "--size", "32x24", "--cases", "4000", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json result = json::parse(outcome.out);
  EXPECT_EQ(keys(result),
            (std::vector<std::string>{"caught", "library_passes", "mutants", "schema", "total"}));
  EXPECT_EQ(result["library_passes"], true);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/mutants/1");
  EXPECT_EQ(result["caught"], result["total"]);
  EXPECT_EQ(result["total"], result["mutants"].size());
  for (const json& mutant : result["mutants"]) {
    EXPECT_EQ(keys(mutant), (std::vector<std::string>{"caught", "name", "property", "seconds"}));
    EXPECT_EQ(mutant["caught"], true);
    EXPECT_TRUE(mutant["property"].is_string());
    EXPECT_GE(mutant["seconds"], 0);
  }
}

// Of one light there is one cut and one bound: the mutants do nothing wrong.
TEST(MutantsCommand, FailsWhereTheyEscape) {
  const OracleProcess oracle;
  const std::vector<std::string> hopeless{"mutants", "cloud?lights=1&blocks=0", "--cases", "10"};
  const Outcome outcome = oracle.run(hopeless);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\n0 of [0-9]+ caught"));
  const json result = json::parse(oracle.run(with(hopeless, {"--json", "-"})).out);
  EXPECT_EQ(result["caught"], 0);
  EXPECT_TRUE(result["mutants"][0]["property"].is_null());
}

} // namespace
} // namespace lightcuts
