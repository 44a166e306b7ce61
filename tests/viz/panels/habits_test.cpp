// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>

#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>
#include <tests/viz/support/gui_robot.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

/// Keys with Ctrl held.
void press_with_control(Robot& robot, int key) {
  robot.hold(GLFW_KEY_LEFT_CONTROL, true);
  robot.press(key);
  robot.hold(GLFW_KEY_LEFT_CONTROL, false);
}

TEST(GuiHabits, SavedViewIsTheSameWhenItIsOpenedAgain) {
  const TemporaryFolder folder;
  ViewState state = small_room();
  state.layer = layers::cut_size;
  state.colours.map = ColourMap::viridis;
  Robot robot(state, {1280, 800}, folder.path / "saved");
  robot.click(robot.on_screen({20, 30}));
  robot.wheel(robot.on_screen({20, 30}), 2);
  robot.settle();
  press_with_control(robot, 'S');
  const auto file = [&](const char* extension) {
    return folder.path / "saved" /
           ("cloud-lights-300-blocks-5-material-glossy-lightcuts-cut-size" +
            std::string(extension));
  };
  EXPECT_EQ(load_view_state(file(".json")), robot.state());
  EXPECT_TRUE(std::filesystem::exists(file(".png")));
  const Film film = read_exr(file(".exr"));
  const auto frame = robot.workbench().sources(methods::lightcuts, layers::image).frame;
  EXPECT_EQ(film.channel("cut-size")[100], frame->rendering().cut_size[100]);
  ASSERT_EQ(robot.workbench().messages().size(), 1U);
  EXPECT_FALSE(robot.workbench().messages().front().error);
}

TEST(GuiHabits, SavingWhereNothingCanBeWrittenIsAMessage) {
  Robot robot(small_room(), {1280, 800}, "/proc/no/such/folder");
  press_with_control(robot, 'S');
  ASSERT_EQ(robot.workbench().messages().size(), 1U);
  EXPECT_TRUE(robot.workbench().messages().front().error);
}

TEST(GuiHabits, TypedSceneIsOpenedAndRemembered) {
  Robot robot(small_room());
  press_with_control(robot, 'O');
  robot.frames(3);
  robot.type("cloud?lights=50&blocks=2");
  robot.press(GLFW_KEY_ENTER);
  robot.settle();
  ASSERT_TRUE(robot.workbench().scene());
  EXPECT_EQ(robot.workbench().scene()->scene().lights.size(), 50U);
  const auto& recent = robot.app().settings().recent;
  ASSERT_EQ(recent.size(), 2U);
  EXPECT_EQ(recent.front(), "cloud?lights=50&blocks=2");
  EXPECT_EQ(recent.back(), small_room().open.spec);
}

TEST(GuiHabits, KeysAreLettersWhileSomebodyTypes) {
  Robot robot(small_room());
  const DisplayMethod display = robot.state().display;
  press_with_control(robot, 'O');
  robot.frames(3);
  robot.press('L');
  robot.press(GLFW_KEY_TAB);
  EXPECT_FALSE(robot.state().colours.logarithmic);
  EXPECT_EQ(robot.state().display, display);
  robot.press(GLFW_KEY_ESCAPE);
  robot.press('L');
  EXPECT_TRUE(robot.state().colours.logarithmic);
}

TEST(GuiHabits, EndsOfTheRangeAreDragged) {
  ViewState state = small_room();
  state.layer = layers::cut_size;
  Robot robot(state);
  const HeatMapScale before = robot.app().image().shown().coloured().scale;
  const Legend& legend = robot.app().legend();
  const glm::dvec2 top = legend.bar_origin() + glm::dvec2(4, 0.25 * legend.bar_size().y);
  robot.drag(top, top + glm::dvec2(0, 0.25 * legend.bar_size().y));
  EXPECT_FALSE(robot.state().colours.automatic_range);
  const HeatMapScale after = robot.app().image().shown().coloured().scale;
  EXPECT_EQ(after.lo, before.lo);
  EXPECT_GT(after.hi, 1.1F * before.hi); // the colours were drawn down
  const glm::dvec2 bottom = legend.bar_origin() + glm::dvec2(4, 0.75 * legend.bar_size().y);
  robot.drag(bottom, bottom - glm::dvec2(0, 0.2 * legend.bar_size().y));
  EXPECT_NE(robot.app().image().shown().coloured().scale.lo, before.lo);
  robot.click(top);
  robot.click(top); // twice at once
  EXPECT_TRUE(robot.state().colours.automatic_range);
}

TEST(GuiHabits, SavedRasterPreviewIsTheImageShown) {
  const TemporaryFolder folder;
  ViewState state = small_room();
  state.display = DisplayMethod::raster();
  Robot robot(state, {1280, 800}, folder.path);
  press_with_control(robot, 'S');
  const Film film =
      read_exr(folder.path / "cloud-lights-300-blocks-5-material-glossy-raster-image.exr");
  const auto& image = robot.app().image().shown().values().image;
  for (std::size_t i = 0; i < film.pixel_count(); ++i)
    ASSERT_EQ(film.channel("G")[i], image[i].g); // no NaN
  EXPECT_EQ(film.metadata.at("method"), "raster");
}

TEST(GuiHabits, LogarithmsTakeTheWholeRangeAgain) {
  ViewState state = small_room();
  state.layer = layers::cut_size;
  state.colours.automatic_range = false;
  state.colours.lo = 0;
  state.colours.hi = 100;
  Robot robot(state);
  robot.press('L');
  EXPECT_TRUE(robot.state().colours.logarithmic);
  EXPECT_TRUE(robot.state().colours.automatic_range); // from 0 there is no logarithm
  EXPECT_NO_THROW((void)read_view_state("saved", view_state_json(robot.state())));
}

TEST(GuiHabits, PageKeysGoThroughTheLayers) {
  Robot robot(small_room());
  std::vector<Layer> seen;
  for (std::size_t i = 0; i < std::size(all_layers); ++i) {
    seen.push_back(robot.state().layer);
    robot.press(GLFW_KEY_PAGE_DOWN);
  }
  EXPECT_EQ(robot.state().layer, seen.front());
  EXPECT_TRUE(std::equal(seen.begin(), seen.end(), std::begin(all_layers)));
  robot.press(GLFW_KEY_PAGE_UP);
  EXPECT_EQ(robot.state().layer, layers::violations);
}

TEST(GuiHabits, ReportRunsAndCanBeLeft) {
  Robot robot(small_room());
  robot.app().show(Tab::plots);
  oracle::MeasureConfig config;
  config.thresholds = {0.02F, 0.2F};
  config.repeats = 1;
  robot.workbench().start_report(config);
  EXPECT_TRUE(robot.workbench().reporting());
  const auto before = robot.screen().screenshot();
  robot.settle();
  ASSERT_TRUE(robot.workbench().report());
  EXPECT_EQ(robot.workbench().report()->report.runs.size(), 3U); // the reference, and two
  robot.frames(2);
  EXPECT_NE(robot.screen().screenshot(), before); // its plots
  config.repeats = 1000;
  robot.workbench().start_report(config);
  robot.frames(2);
  robot.workbench().cancel_report();
  robot.settle(20);
  EXPECT_FALSE(robot.workbench().reporting());
  EXPECT_EQ(robot.workbench().report()->report.repeats, 1); // the last good one stays
}

TEST(GuiHabits, TreeZoomsAtTheCursor) {
  Robot robot(small_room());
  const ScreenArea area = robot.app().image().area();
  const auto before = robot.screen().screenshot();
  robot.wheel({area.origin.x + 300, 700}, 5);
  const auto zoomed = robot.screen().screenshot();
  EXPECT_NE(zoomed, before);
  EXPECT_TRUE(robot.state().image.fits); // not the image
}

TEST(GuiHabits, NaNsAndInfinitiesAreCounted) {
  LayerValues layer{.size = {2, 2},
                    .values = {1, inf, std::nanf(""), 2},
                    .known = {1, 1, 1, 1},
                    .own = {1, 1, 1, 1},
                    .surface = {1, 1, 1, 1}};
  const Coloured c = coloured(layers::slack, layer, {});
  EXPECT_EQ(c.statistics.nan, 1U);
  EXPECT_EQ(c.statistics.infinite, 1U);
  EXPECT_EQ(c.pixels[1], infinity_colour);
  EXPECT_EQ(c.pixels[2], nan_colour);
  EXPECT_EQ(c.scale.hi, 2);
}

} // namespace
} // namespace lightcuts::viz
