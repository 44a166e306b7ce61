// SPDX-License-Identifier: MIT
#include <set>

#include <gtest/gtest.h>
#include <lightcuts/core/cut/cut_selector.h>

#include <tests/viz/support/gui_robot.h>
#include <viz/model/layers/all_layers.h>
#include <viz/model/picture/outline.h>

namespace lightcuts::viz {
namespace {

/// What CutSelector returns for the pixel.
std::set<std::uint32_t> cut_by_the_library(Workbench& workbench, glm::uvec2 pixel) {
  const OpenedScene& scene = *workbench.scene();
  const auto p = scene.view().at(pixel);
  const CutConfig config{0.02F, default_max_cut, scene.black_level(), !scene.view().may_occlude()};
  CutSelector select(*scene.tree(), config);
  const Cut cut = select(p->point, [&](std::uint32_t i) { return scene.view().sees(*p, i); });
  std::set<std::uint32_t> nodes;
  for (const CutCluster& c : cut.clusters) nodes.insert(c.node);
  return nodes;
}

std::set<std::uint32_t> cut_shown(Workbench& workbench) {
  std::set<std::uint32_t> nodes;
  for (const ClusterRow& row : workbench.inspection()->inspection.clusters) nodes.insert(row.node);
  return nodes;
}

TEST(GuiSelection, ClickedPixelShowsTheCutThatTheLibraryPicks) {
  Robot robot(small_room());
  for (const glm::uvec2 pixel : {glm::uvec2(20, 30), glm::uvec2(50, 12), glm::uvec2(0, 47)}) {
    robot.click(robot.on_screen(pixel));
    ASSERT_EQ(robot.state().pixel, pixel);
    robot.settle();
    ASSERT_TRUE(robot.workbench().inspection());
    const Inspection& inspection = robot.workbench().inspection()->inspection;
    EXPECT_EQ(cut_shown(robot.workbench()), cut_by_the_library(robot.workbench(), pixel));
    EXPECT_GT(inspection.clusters.size(), 3U);
    // And the picture's pixel is that cut's.
    const auto frame = robot.workbench().sources(methods::lightcuts, layers::image).frame;
    EXPECT_EQ(frame->rendering().radiance[pixel.y * 64 + pixel.x], inspection.radiance);
    EXPECT_TRUE(inspection.truth);
  }
}

TEST(GuiSelection, ArrowsMoveThePixelAndEscapeLetsGo) {
  Robot robot(small_room());
  robot.click(robot.on_screen({20, 30}));
  robot.press(GLFW_KEY_RIGHT);
  robot.press(GLFW_KEY_UP);
  EXPECT_EQ(robot.state().pixel, glm::uvec2(21, 29));
  robot.hold(GLFW_KEY_LEFT_SHIFT, true);
  robot.press(GLFW_KEY_LEFT);
  robot.hold(GLFW_KEY_LEFT_SHIFT, false);
  EXPECT_EQ(robot.state().pixel, glm::uvec2(11, 29));
  for (int i = 0; i < 20; ++i) robot.press(GLFW_KEY_LEFT);
  EXPECT_EQ(robot.state().pixel, glm::uvec2(0, 29)); // no farther than the edge
  robot.press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(robot.state().pixel);
}

/// Of the screenshot, how many of the points along the pixel edge have the outline's colour.
int outlined(Robot& robot, const PixelEdge& edge) {
  const auto& image = robot.app().image();
  const auto shot = robot.screen().screenshot();
  const auto is_blue = [&](const glm::dvec2& at) { // antialiased, so not one colour
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const glm::ivec2 p = glm::ivec2(at) + glm::ivec2(x, y);
        const Rgb8& c = shot[std::size_t(p.y) * robot.screen().size().x + std::size_t(p.x)];
        if (c.b > c.r + 60 && c.b > 100) return true;
      }
    return false;
  };
  int count = 0;
  for (const double t : {0.3, 0.5, 0.7})
    if (is_blue(to_screen(image.view(), image.area(),
                          glm::mix(glm::dvec2(edge.from), glm::dvec2(edge.to), t))))
      ++count;
  return count;
}

TEST(GuiSelection, OutlinesThePixelsThatShareTheClickedPixelsCut) {
  Robot robot(small_room());
  robot.state().display = methods::block_cuts;
  robot.settle();
  robot.click(robot.on_screen({20, 30}));
  robot.settle();
  robot.move({5, 5}); // no tooltip in the way
  const std::vector<glm::uvec2> block = robot.workbench().inspection()->inspection.block;
  ASSERT_GT(block.size(), 1U);
  std::vector<PixelEdge> outline = outline_of(block);
  // The selected pixel's own outline lies above.
  std::erase_if(outline, [](const PixelEdge& e) {
    return glm::distance(0.5 * glm::dvec2(e.from + e.to), glm::dvec2(20.5, 30.5)) < 1.2;
  });
  ASSERT_FALSE(outline.empty());
  int seen = 0;
  for (const PixelEdge& edge : outline) seen += outlined(robot, edge);
  EXPECT_EQ(seen, 3 * int(outline.size()));
  // Not where it does not go, and not by a method that lights each pixel alone.
  EXPECT_EQ(outlined(robot, {{50, 10}, {51, 10}}), 0);
  robot.state().display = methods::lightcuts;
  robot.settle();
  for (const PixelEdge& edge : outline) EXPECT_EQ(outlined(robot, edge), 0);
}

TEST(GuiSelection, StepsThroughRefinementsAndBack) {
  Robot robot(small_room());
  robot.click(robot.on_screen({20, 30}));
  robot.settle();
  const auto last = robot.workbench().inspection()->inspection.final_size;
  ASSERT_GT(last, 5U);
  for (int i = 0; i < 3; ++i) {
    robot.press(',');
    robot.settle();
  }
  EXPECT_EQ(robot.state().step, last - 3);
  const Inspection& step = robot.workbench().inspection()->inspection;
  ASSERT_EQ(step.clusters.size(), last - 3);
  ASSERT_TRUE(step.refined_next);
  const std::uint32_t refined = *step.refined_next;
  EXPECT_EQ(cut_shown(robot.workbench()).count(refined), 1U);
  robot.press('.');
  robot.settle();
  EXPECT_EQ(cut_shown(robot.workbench()).count(refined), 0U);
  robot.press('.');
  robot.press('.');
  EXPECT_FALSE(robot.state().step);
}

TEST(GuiSelection, ClusterClickedInTheTreeIsSelectedEverywhere) {
  Robot robot(small_room());
  robot.click(robot.on_screen({20, 30}));
  robot.settle();
  // The root is the topmost block of the icicle, over all of its width: in the left lower part.
  const ScreenArea area = robot.app().image().area();
  bool found = false;
  for (double y = area.origin.y + area.size.y + 20; y < 800 && !found; y += 6) {
    robot.click({area.origin.x + 200, y});
    found = robot.state().node == 0U;
  }
  EXPECT_TRUE(found);
  const auto row = robot.workbench().selected_row();
  ASSERT_TRUE(row);
  EXPECT_EQ(row->lights, 300U);
}

} // namespace
} // namespace lightcuts::viz
