// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightcuts {
namespace {

using testing::HasSubstr;

TEST(ScenesCommand, ListsTheBuiltinScenes) {
  const Outcome outcome = OracleProcess().run({"scenes"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* name : {"desk ", "desk-red ", "bedroom ", "cloud "})
    EXPECT_THAT(outcome.out, HasSubstr(name));
}

TEST(ScenesCommand, ListsThemAsJson) {
  const Outcome outcome = OracleProcess().run({"scenes", "--json", "-"});
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/scenes/1");
  EXPECT_EQ(result["scenes"][0]["name"], "desk");
}

TEST(ErrorsCommand, ComparesSumsWithWhatTheyCanBeOff) {
  const Outcome outcome = OracleProcess().run({"errors", "--lights", "2e5", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto sums = nlohmann::json::parse(outcome.out)["sums"];
  ASSERT_EQ(sums.size(), 6U); // 10 to 10^5, and 2 10^5
  EXPECT_EQ(sums[5]["lights"], 200'000);
  for (const auto& row : sums) {
    EXPECT_LE(row["float"], row["most_in_float"]);
    EXPECT_LE(row["double"], row["most_in_double"]);
    EXPECT_LE(row["compensated"], row["most_compensated"]);
  }
  EXPECT_GT(sums[5]["float"], sums[5]["double"]);
  EXPECT_GT(sums[5]["double"], sums[5]["compensated"]);
}

TEST(InfoCommand, SaysWhatIsNeededAndLeftOut) {
  const Outcome outcome = OracleProcess().run({"info", "cloud?lights=20&blocks=0"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("lights       20 omni"));
  EXPECT_THAT(outcome.out, HasSubstr("left out     shadow rays"));
  EXPECT_THAT(outcome.out, HasSubstr("left out     light tree"));
}

TEST(InfoCommand, SaysWhatLuminairesSend) {
  const OracleProcess oracle;
  const std::string file = LIGHTCUTS_TEST_FILES "/json/profile.json";
  EXPECT_THAT(oracle.run({"info", file}).out,
              HasSubstr("luminaires   3 of 2 profiles, which send "));
  const auto result = nlohmann::json::parse(
      oracle.run({"info", "cloud?lights=20&kind=profile", "--json", "-"}).out);
  EXPECT_EQ(result["luminaires"]["lights"], 20);
  EXPECT_EQ(result["luminaires"]["profiles"], 1);
  EXPECT_GT(result["luminaires"]["watts"][0], 0);
  EXPECT_THAT(oracle.run({"info", "desk"}).out, testing::Not(HasSubstr("luminaires")));
}

TEST(InfoCommand, SaysItAsJson) {
  const Outcome outcome =
      OracleProcess().run({"info", "cloud?lights=20", "--size", "31x17", "--json", "-"});
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/info/1");
  EXPECT_EQ(result["lights"], 20);
  EXPECT_EQ(result["width"], 31);
  EXPECT_EQ(result["height"], 17);
  EXPECT_EQ(result["needed"][0], "omni lights");
  EXPECT_EQ(result["needed"].size() + result["left_out"].size(), 6U);
  EXPECT_THAT(result["method"].get<std::string>(), HasSubstr("lightcuts, summing all lights"));
}

TEST(RenderCommand, WritesPicturesToTheFolder) {
  const OracleProcess oracle;
  const Outcome outcome =
      oracle.run({"render", "cloud?lights=5", "--size", "16x12", "--out", "a b/ü"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("written to a b/ü"));
  EXPECT_THAT(oracle.files(),
              testing::IsSupersetOf({"a b/ü/image.exr", "a b/ü/image.png", "a b/ü/cut-size.png"}));
  EXPECT_EQ(oracle.files().size(), 7U); // two folders and five files
}

TEST(RenderCommand, TakesTheMethodThatInfoNames) {
  const OracleProcess oracle;
  const Outcome info = oracle.run({"info", "cloud?lights=5000", "--size", "32x24"});
  EXPECT_THAT(info.out,
              HasSubstr("\nmethod       block-cuts at 4 %; expected cost, all lights 1: "));
  const Outcome render =
      oracle.run({"render", "cloud?lights=5000", "--size", "32x24", "--json", "-"});
  const auto result = nlohmann::json::parse(render.out);
  EXPECT_EQ(result["method"], "block-cuts");
  EXPECT_EQ(result["threshold"], 0.04);
}

TEST(RenderCommand, RendersGroupsOfLightsByThemselves) {
  const OracleProcess oracle;
  write(oracle.folder() / "floor.obj", "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nf 3 2 1\n");
  write(oracle.folder() / "lit.json",
        R"({"geometry": "floor.obj", "image": {"width": 8, "height": 8},
            "camera": {"position": [0, 2, 0.1], "target": [0, 0, 0]},
            "lights": [{"position": [0, 2, 0], "intensity": 3, "group": "lamps"},
                       {"position": [0, 2, 0], "intensity": [1, 0, 0]},
                       {"position": [0, 2, 0], "intensity": 1, "group": "candles"}]})");
  const Outcome outcome = oracle.run({"render", "lit.json", "--groups", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = nlohmann::json::parse(outcome.out);
  const auto& groups = result["groups"];
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0]["name"], "lamps");
  EXPECT_EQ(groups[2]["name"], "others");
  EXPECT_NEAR(groups[0]["share_of_light"].get<double>(), 9.0 / 13, 1e-6);
  EXPECT_NEAR(groups[1]["share_of_light"].get<double>(), 3.0 / 13, 1e-6);
  EXPECT_NEAR(groups[2]["share_of_light"].get<double>(), 1.0 / 13, 1e-6);
  EXPECT_THAT(oracle.run({"render", "lit.json", "--groups"}).out,
              HasSubstr("group candles: 1 light, 23.08 % of the light"));
  EXPECT_THAT(oracle.run({"info", "lit.json"}).out, HasSubstr("group        lamps: 1 light\n"));
  const Outcome refused = oracle.run({"render", "desk", "--groups"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("desk: no light has a group"));
}

TEST(RenderCommand, SaysWhereTheCameraSeesNothing) {
  const OracleProcess oracle;
  write(oracle.folder() / "floor.obj", "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nf 1 2 3\n");
  write(oracle.folder() / "away.json",
        R"({"geometry": "floor.obj", "image": {"width": 4, "height": 4},
            "camera": {"position": [0, 1, 0], "target": [0, 2, 0.1]},
            "lights": [{"position": [0, 2, 0], "intensity": 1}]})");
  const Outcome outcome = oracle.run({"render", "away.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("the camera sees no surface"));
}

TEST(RenderCommand, NamesTheFolderAfterTheScene) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run({"render", "cloud?lights=5", "--size", "4x3", "--threshold",
                                      "0.5", "--method", "reference", "--json", "-"});
  EXPECT_TRUE(exists(oracle.folder() / "out" / "cloud-lights-5" / "image.exr"));
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["schema"], "lightcuts-oracle/render/1");
  EXPECT_EQ(result["method"], "reference");
  EXPECT_EQ(result["threshold"], 0.5);
  EXPECT_EQ(result["mean_cut_size"], 5);
}

} // namespace
} // namespace lightcuts
