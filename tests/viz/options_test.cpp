// SPDX-License-Identifier: MIT
#include <viz/options.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>

#include <oracle/options/scene_options.h>
#include <oracle/options/values.h>
#include <tests/render/support/temporary_folder.h>
#include <viz/model/layers/all_layers.h>
#include <viz/model/scene/opened_scene.h>

namespace lightcuts::viz {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

void parse(CLI::App& command, Arguments arguments) {
  std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
  command.parse(std::move(arguments));
}

ViewState view_of(const Arguments& arguments) {
  CLI::App command;
  Options options;
  add_options(command, options);
  parse(command, arguments);
  return options.view;
}

/// What lightcuts-oracle opens.
Scene opened_by_the_command_line(const Arguments& arguments) {
  CLI::App command;
  SceneRequest request;
  options::add_scene_options(command, request, "--size");
  parse(command, arguments);
  return open_scene(request);
}

void expect_same_lights(const LightSet& a, const LightSet& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.min_distance(), b.min_distance());
  for (std::uint32_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i], b[i]) << i;
}

TEST(Options, OpenASceneWithTheLightsThatTheCommandLineMakes) {
  for (const Arguments& arguments :
       {Arguments{"desk"}, Arguments{"desk", "--vpls", "40"},
        Arguments{"desk", "--lights", "30", "--surfels", "20", "--min-distance", "0.1"},
        Arguments{"desk", "--area-lights", "25", "--vpls", "10"}}) {
    const OpenedScene opened(view_of(arguments).open);
    expect_same_lights(opened.scene().lights, opened_by_the_command_line(arguments).lights);
  }
}

TEST(Options, OfLightsDoWhatTheirGeneratorsDo) {
  Scene expected = open_scene("desk");
  const std::size_t own = expected.lights.size();
  add_virtual_point_lights(expected, {.paths = 40, .seed = 7});
  ASSERT_GT(expected.lights.size(), own);
  expect_same_lights(
      OpenedScene(view_of({"desk", "--vpls", "40", "--seed", "7"}).open).scene().lights,
      expected.lights);
  expected = open_scene("desk");
  add_surfels(expected, {.count = 20, .seed = 1});
  expect_same_lights(OpenedScene(view_of({"desk", "--surfels", "20"}).open).scene().lights,
                     expected.lights);
}

TEST(Options, ChangeOnlyWhatIsAskedForOfAStateWhereverItStands) {
  ViewState saved;
  saved.open = {.spec = "cloud", .image_size = glm::uvec2(64, 48), .vpls = 5};
  saved.shading.threshold = 0.25F;
  saved.shading.max_cut = 77;
  saved.display = methods::paper;
  saved.colours.map = ColourMap::turbo;
  const TemporaryFolder folder;
  const std::string file = (folder.path / "view.json").string();
  write(file, view_state_json(saved));
  EXPECT_EQ(view_of({"--state", file}), saved);
  ViewState expected = saved;
  expected.open.spec = "desk";
  expected.open.vpls = 9;
  expected.shading.threshold = 0.02F;
  expected.layer = layers::cut_size;
  EXPECT_EQ(
      view_of({"desk", "--vpls", "9", "--threshold", "2%", "--state", file, "--layer", "cut-size"}),
      expected);
}

TEST(Options, ShowTheBedroomByDefault) { EXPECT_EQ(view_of({}).open.spec, "bedroom"); }

std::string refusal_of(const Arguments& arguments) {
  try {
    (void)view_of(arguments);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

TEST(Options, RefuseBadValuesInTheWordsOfTheCommandLine) {
  EXPECT_THAT(refusal_of({"--image-size", "0x10"}), HasSubstr(options::check_size("0x10")));
  EXPECT_THAT(refusal_of({"--size", "10x16385"}), HasSubstr(options::check_size("10x16385")));
  EXPECT_THAT(refusal_of({"--threshold", "2%%"}), HasSubstr(options::check_threshold("2%%")));
  EXPECT_THAT(refusal_of({"--lights", "0"}), HasSubstr("'0' is not a whole number above 0"));
  EXPECT_THAT(refusal_of({"--max-cut", "-1"}), HasSubstr("'-1' is not a whole number above 0"));
  EXPECT_THAT(refusal_of({"--pixel", "3x4"}), HasSubstr("'3x4' is not X,Y"));
  EXPECT_THAT(refusal_of({"--layer", "cut"}), HasSubstr("cut-size"));
  EXPECT_THAT(refusal_of({"--vpls", "5", "--surfels", "5"}), HasSubstr("--surfels"));
}

TEST(OptionValues, AreReadAsTheyAreMeant) {
  EXPECT_EQ(options::parse_size("640x480"), glm::uvec2(640, 480));
  EXPECT_EQ(options::parse_size("1x16384"), glm::uvec2(1, 16384));
  for (const char* text :
       {"", "x", "640", "640x", "x480", "-1x5", "4x5x6", "4 x5", "0x1", "1x16385"})
    EXPECT_FALSE(options::parse_size(text)) << text;
  EXPECT_EQ(options::parse_threshold("2%"), 0.02F);
  EXPECT_EQ(options::parse_threshold("0.02"), 0.02F);
  EXPECT_EQ(options::parse_threshold("0"), 0.0F);
  for (const char* text : {"", "x", "auto", "nan", "inf", "-1%", "2%%", "% 2"})
    EXPECT_FALSE(options::parse_threshold(text)) << text;
  EXPECT_EQ(options::check_threshold("auto"), "");
}

} // namespace
} // namespace lightcuts::viz
