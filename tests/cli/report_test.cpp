// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightcuts {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::vector<std::string> small_report{
    "report", "cloud?lights=20", "--size", "16x12", "--repeats", "1", "--thresholds", "2%,8%"};

TEST(ReportCommand, WritesEverythingToTheFolder) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run(with(small_report, {"--out", "results"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("written to results"));
  for (const char* name : {"report.html", "report.json", "report.csv", "image.exr", "image.png",
                           "reference.png", "cut-size.png", "error.png"})
    EXPECT_TRUE(exists(oracle.folder() / "results" / name)) << name;
  EXPECT_EQ(json::parse(content_of(oracle.folder() / "results" / "report.json"))["runs"].size(),
            3U);
}

TEST(ReportCommand, PrintsJsonAndNothingElse) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run(with(small_report, {"--json", "-"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["schema"], "lightcuts-oracle/report/1");
  EXPECT_EQ(report["scene"], "cloud?lights=20");
  EXPECT_EQ(report["lights"], 20);
  EXPECT_GT(report["triangles"], 0);
  const std::vector<std::string> numbers{"threshold",
                                         "build_seconds",
                                         "render_seconds",
                                         "mean_cut_size",
                                         "shadow_rays_per_pixel",
                                         "rel_rmse",
                                         "mean_relative_error",
                                         "max_relative_error",
                                         "pixels_over_threshold",
                                         "speedup_over_reference",
                                         "optimal_cut_size",
                                         "cut_efficiency"};
  ASSERT_EQ(report["runs"].size(), 3U);
  for (const json& run : report["runs"]) {
    EXPECT_TRUE(run["method"].is_string());
    for (const std::string& name : numbers) EXPECT_TRUE(run[name].is_number()) << name;
  }
  EXPECT_EQ(report["runs"][0]["method"], "reference");
  EXPECT_EQ(report["runs"][0]["rel_rmse"], 0);
  EXPECT_EQ(content_of(oracle.folder() / "out" / "cloud-lights-20" / "report.json"), outcome.out);
}

TEST(ReportCommand, TakesTheSceneAfterItsLists) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"report", "--repeats", "1", "--thresholds", "5%", "--methods",
                                      "lightcuts", "cloud?lights=9", "--size", "8x6"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(exists(oracle.folder() / "out" / "cloud-lights-9" / "report.html"));
}

TEST(ReportCommand, OverwritesAnEarlierReport) {
  const OracleProcess oracle;
  create_directory(oracle.folder() / "results");
  write(oracle.folder() / "results" / "report.csv", "old");
  write(oracle.folder() / "results" / "mine.txt", "mine");
  EXPECT_EQ(oracle.run(with(small_report, {"--out", "results"})).exit_code, 0);
  EXPECT_NE(content_of(oracle.folder() / "results" / "report.csv"), "old");
  EXPECT_EQ(content_of(oracle.folder() / "results" / "mine.txt"), "mine");
}

// The scene fails when the folder is known to be good already.
TEST(ReportCommand, LeavesAnEarlierReportAloneWhereItFails) {
  const OracleProcess oracle;
  create_directory(oracle.folder() / "results");
  write(oracle.folder() / "results" / "report.json", "old");
  write(oracle.folder() / "away.json",
        R"({"geometry": "floor.obj", "image": {"width": 4, "height": 4},
            "camera": {"position": [0, 1, 0], "target": [0, 2, 0.1]},
            "lights": [{"position": [0, 2, 0], "intensity": 1}]})");
  write(oracle.folder() / "floor.obj", "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nf 1 2 3\n");
  const Outcome outcome = oracle.run({"report", "away.json", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("sees no surface"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(content_of(oracle.folder() / "results" / "report.json"), "old");
  EXPECT_EQ(oracle.files().size(), 4U);
}

} // namespace
} // namespace lightcuts
