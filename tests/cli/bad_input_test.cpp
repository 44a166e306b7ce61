// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/render/support/gltf_file.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;

const std::string square = "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nf 1 2 3\nf 1 3 4\n";

/// A scene of the square with one more member.
std::string scene_json(const std::string& more) {
  return "{\"geometry\": \"square.obj\",\n" + more + "}\n";
}

struct BadFile {
  const char* name;
  std::string file, content;
  std::vector<std::string> says; ///< on stderr
};

void expect_refusal(const Outcome& outcome, const std::vector<std::string>& says) {
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.find("lightcuts-oracle: "), 0U) << outcome.err;
  for (const std::string& part : says) EXPECT_THAT(outcome.err, HasSubstr(part));
}

class Input : public testing::TestWithParam<BadFile> {};

TEST_P(Input, IsRefusedInOneLineThatNamesTheFile) {
  const BadFile& bad = GetParam();
  const OracleProcess oracle;
  write(oracle.folder() / "square.obj", square);
  write(oracle.folder() / bad.file, bad.content);
  const std::size_t files = oracle.files().size();
  expect_refusal(oracle.run({"render", bad.file, "--size", "4x3"}), bad.says);
  EXPECT_EQ(oracle.files().size(), files);
}

std::string with_light(const std::string& position, const std::string& intensity) {
  return scene_json("\"lights\": [{\"position\": [0, 1, 0], \"intensity\": 1},\n{\"position\": " +
                    position + ", \"intensity\": " + intensity + "}]");
}

INSTANTIATE_TEST_SUITE_P(
    Cli, Input,
    testing::Values(
        BadFile{"TruncatedObj", "cut.obj", square.substr(0, square.size() - 20), {"cut.obj"}},
        BadFile{"TruncatedGltf", "cut.gltf", test::gltf().dump().substr(0, 900), {"cut.gltf"}},
        BadFile{"TruncatedGlb", "cut.glb", test::glb(test::gltf()).substr(0, 500), {"cut.glb"}},
        BadFile{"EmptyFile", "empty.obj", "", {"empty.obj"}},
        BadFile{"EmptyMesh", "points.obj", "v 0 0 0\nv 1 0 0\n", {"points.obj", "no triangles"}},
        BadFile{"UnknownExtension",
                "scene.blend",
                "x",
                {"scene.blend", "unknown kind of scene '.blend'"}},
        BadFile{"NanVertex", "nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"nan.obj"}},
        BadFile{"WithoutLights", "dark.obj", square, {"dark.obj", "no lights", "--lights 1000"}},
        BadFile{"NegativeIntensity",
                "neg.json",
                with_light("[0, 1, 0]", "[1, -2, 1]"),
                {"neg.json", "/lights/1/intensity/1", "negative"}},
        BadFile{"NanIntensity", "nan.json", with_light("[0, 1, 0]", "NaN"), {"nan.json", "line 3"}},
        BadFile{"InfiniteIntensity",
                "inf.json",
                with_light("[0, 1, 0]", "1e39"),
                {"inf.json", "/lights/1/intensity"}},
        BadFile{"WrongType",
                "type.json",
                with_light("\"here\"", "1"),
                {"type.json", "/lights/1/position"}},
        BadFile{"WrongTypeOfGeometry",
                "geometry.json",
                "{\"geometry\": 7}",
                {"geometry.json", "/geometry"}},
        BadFile{"MalformedJson",
                "bad.json",
                scene_json("\"lights\": [}"),
                {"bad.json", "line 2", "column 12"}},
        BadFile{"MissingGeometry", "far.json", "{\"geometry\": \"nowhere.obj\"}", {"nowhere.obj"}},
        BadFile{
            "UnknownMember", "typo.json", scene_json("\"ligths\": []"), {"typo.json", "ligths"}},
        BadFile{"UnknownTypeOfLight",
                "laser.json",
                scene_json(R"("lights": [{"type": "laser"}])"),
                {"laser.json", "/lights/0/type", "'laser'"}},
        BadFile{"AngleOutOfRange",
                "wide.json",
                scene_json(R"("lights": [{"type": "spot", "position": [0, 1, 0], "outer": 190}])"),
                {"wide.json", "/lights/0/outer", "190"}},
        BadFile{"NothingThatEmits",
                "unlit.json",
                scene_json(R"("lights": [{"generate": "area", "count": 5}])"),
                {"unlit.json", "/lights/0", "no surface emits light"}},
        BadFile{"MissingEnvironment",
                "night.json",
                scene_json(R"("lights": [{"generate": "environment", "file": "nowhere.exr"}])"),
                {"night.json", "/lights/0", "nowhere.exr"}},
        BadFile{"NegativeDistance",
                "near.json",
                scene_json(R"("min_distance": -1)"),
                {"near.json", "/min_distance", "-1"}},
        BadFile{"ZeroWidth",
                "size.json",
                scene_json("\"image\": {\"width\": 0, \"height\": 9}"),
                {"size.json", "/image/width"}}),
    [](const auto& of) { return of.param.name; });

TEST(InputMissing, IsRefused) {
  const OracleProcess oracle;
  expect_refusal(oracle.run({"check", "no such.obj"}), {"no such.obj"});
  expect_refusal(oracle.run({"check", "ü.json"}), {"ü.json"});
  expect_refusal(oracle.run({"check", ""}), {"unknown built-in scene ''"});
}

TEST(InputFolder, IsRefused) {
  const OracleProcess oracle;
  for (const char* name : {"folder.obj", "folder.json", "folder.glb"}) {
    create_directory(oracle.folder() / name);
    expect_refusal(oracle.run({"check", name}), {name});
  }
}

TEST(InputBuiltin, IsRefusedWhereItIsUnknown) {
  const OracleProcess oracle;
  expect_refusal(oracle.run({"check", "dask"}), {"'dask'", "desk"});
  expect_refusal(oracle.run({"check", "cloud?lites=3"}), {"cloud", "lites"});
  expect_refusal(oracle.run({"check", "cloud?lights=-3"}), {"lights"});
}

TEST(InputLights, CanBeAdded) {
  const OracleProcess oracle;
  write(oracle.folder() / "dark room.obj", square);
  const Outcome outcome =
      oracle.run({"check", "dark room.obj", "--lights", "5", "--size", "8x6", "--cases", "100"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(oracle.run({"info", "dark room.obj"}).exit_code, 0);
  EXPECT_EQ(oracle.run({"check", "--lights", "100000001"}).exit_code, 3);
}

TEST(InputLights, CanBeMadeOfWhatShines) {
  const OracleProcess oracle;
  write(oracle.folder() / "square.obj", square);
  write(oracle.folder() / "lit.json",
        scene_json(R"("lights": [{"position": [0, 1, 0], "intensity": 1}])"));
  const auto notes = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"info", "lit.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = oracle.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(notes({"--vpls", "50", "--min-distance", "0.1"}), HasSubstr("from 50 light paths"));
  EXPECT_THAT(notes({"--surfels", "40"}), HasSubstr("from 40 surfels"));
  // A picture's pixels as radiances: one that the program itself has drawn.
  EXPECT_EQ(oracle.run({"render", "lit.json", "--size", "8x4", "--out", "out"}).exit_code, 0);
  EXPECT_THAT(notes({"--environment", "out/image.exr", "--environment-lights", "3"}),
              HasSubstr("3 directional lights from out/image.exr"));
  EXPECT_THAT(oracle.run({"info", "desk", "--area-lights", "500"}).err,
              HasSubstr("500 area lights from 432 triangles"));
}

TEST(InputLights, AreRefusedWhereNothingShines) {
  const OracleProcess oracle;
  write(oracle.folder() / "dark.obj", square);
  write(oracle.folder() / "text.exr", "not an image");
  const auto refuses = [&](const std::string& option, const std::string& value,
                           const std::string& why) {
    expect_refusal(oracle.run({"check", "dark.obj", option, value}), {"dark.obj", why});
  };
  refuses("--area-lights", "5", "no surface emits light");
  refuses("--vpls", "5", "no light to start from");
  refuses("--surfels", "5", "no light to reflect");
  refuses("--environment", "text.exr", "text.exr");
  refuses("--area-lights", "100000001", "count is 100000001");
}

void expect_usage(const std::vector<std::vector<std::string>>& all) {
  const OracleProcess oracle;
  for (const std::vector<std::string>& options : all) {
    std::vector<std::string> arguments{"check", "desk"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(oracle.run(arguments).exit_code, 2) << options[0] << ' ' << options[1];
  }
}

TEST(InputLights, AreRefusedAsUsageWhereTheCountIsNone) {
  expect_usage({{"--area-lights", "0"},
                {"--vpls", "-1"},
                {"--surfels", "1.5"},
                {"--environment", "x.exr", "--environment-lights", "0"}});
}

TEST(InputLights, AreRefusedAsUsageWhereOptionsContradict) {
  expect_usage({{"--vpls", "5", "--surfels", "5"}, {"--environment-lights", "5"}});
}

TEST(MinDistanceOption, IsRefusedAsUsageUnlessItIsANumberAbove0) {
  expect_usage({{"--min-distance", "0"},
                {"--min-distance", "-1"},
                {"--min-distance", "nan"},
                {"--min-distance", "inf"},
                {"--min-distance", "1m"}});
}

TEST(InputName, NeedNotBeUtf8) {
  const OracleProcess oracle;
  write(oracle.folder() / "\xff.obj", square);
  const Outcome outcome = oracle.run({"info", "\xff.obj", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\xef\xbf\xbd")); // the replacement character
}

TEST(Stdout, ThatIsFullIsReported) {
  const Outcome outcome = OracleProcess().run({"scenes"}, "/dev/full");
  expect_refusal(outcome, {"stdout: cannot be written"});
}

// Below a regular file there can be no folder, not even for root.
TEST(OutputFolderOption, IsRefusedWhereItCannotBeWritten) {
  const OracleProcess oracle;
  write(oracle.folder() / "file", "mine");
  for (const char* command : {"render", "report"}) {
    expect_refusal(oracle.run({command, "desk", "--size", "4x3", "--out", "file/out"}), {"file"});
    expect_refusal(oracle.run({command, "desk", "--size", "4x3", "--out", "file"}), {"file"});
  }
  EXPECT_EQ(content_of(oracle.folder() / "file"), "mine");
  EXPECT_EQ(oracle.files().size(), 1U);
}

// Found out before the long job, and before the results replace older ones.
TEST(JsonOption, IsRefusedWhereItCannotBeWritten) {
  const OracleProcess oracle;
  create_directory(oracle.folder() / "folder");
  for (const char* file : {"folder", "nowhere/x.json", "x.json/"})
    expect_refusal(oracle.run({"report", "desk", "--json", file}), {file});
  for (const char* command : {"render", "check", "info"})
    expect_refusal(oracle.run({command, "desk", "--json", "nowhere/x"}), {"nowhere/x"});
  for (const char* command : {"mutants", "stress"})
    expect_refusal(oracle.run({command, "--json", "nowhere/x"}), {"nowhere/x"});
  EXPECT_EQ(oracle.run({"scenes", "--json", "nowhere/x.json"}).exit_code, 3);
  EXPECT_EQ(oracle.files().size(), 1U);
}

} // namespace
} // namespace lightcuts
