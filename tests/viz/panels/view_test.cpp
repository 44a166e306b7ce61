// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <lightcuts/render/view/camera.h>
#include <tests/viz/support/gui_robot.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

TEST(GuiView, TabCyclesMethodsWithoutLosingViewOrSelection) {
  Robot robot(small_room());
  robot.click(robot.on_screen({20, 30}));
  robot.wheel(robot.on_screen({20, 30}), 3);
  const ImageView view = robot.state().image;
  const DisplayMethod first = robot.state().display;
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < std::size(all_displays); ++i) {
    robot.press(GLFW_KEY_TAB);
    seen.emplace_back(name_of(robot.state().display));
    EXPECT_EQ(robot.state().image, view);
    EXPECT_EQ(robot.state().pixel, glm::uvec2(20, 30));
  }
  EXPECT_EQ(robot.state().display, first);
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end()); // each of them once
  robot.hold(GLFW_KEY_LEFT_SHIFT, true);
  robot.press(GLFW_KEY_TAB);
  robot.hold(GLFW_KEY_LEFT_SHIFT, false);
  EXPECT_EQ(robot.state().display, next(first, -1));
}

TEST(GuiView, WheelKeepsThePixelUnderTheCursor) {
  Robot robot(small_room());
  const glm::dvec2 at = glm::floor(robot.on_screen({13, 37})); // as mice are
  const auto under_cursor = [&] {
    return to_image(robot.app().image().view(), robot.app().image().area(), at);
  };
  const glm::dvec2 before = under_cursor();
  const double zoom = robot.app().image().view().zoom;
  for (const float by : {4.0F, 2.0F, -3.0F}) {
    robot.wheel(at, by);
    EXPECT_NEAR(under_cursor().x, before.x, 1e-6);
    EXPECT_NEAR(under_cursor().y, before.y, 1e-6);
  }
  EXPECT_GT(robot.app().image().view().zoom, 1.5 * zoom);
  robot.press('F');
  EXPECT_NEAR(robot.app().image().view().zoom, zoom, 1e-6);
  robot.press('1');
  EXPECT_EQ(robot.app().image().view().zoom, 1);
}

TEST(GuiView, DragPansAndDoesNotSelect) {
  Robot robot(small_room());
  const glm::dvec2 from = robot.on_screen({30, 20});
  const glm::dvec2 before = to_image(robot.app().image().view(), robot.app().image().area(), from);
  robot.drag(from, from + glm::dvec2(80, 40));
  const glm::dvec2 after =
      to_image(robot.app().image().view(), robot.app().image().area(), from + glm::dvec2(80, 40));
  EXPECT_LT(glm::length(after - before), 1.0); // but for what it takes to call it a drag
  EXPECT_FALSE(robot.state().pixel);
}

TEST(GuiView, SpaceShowsTheReferenceWhileHeld) {
  ViewState state = small_room();
  state.display = methods::unscaled;
  state.shading.threshold = 0.5F;
  Robot robot(state);
  const auto shown = robot.app().image().shown().values().image;
  robot.hold(GLFW_KEY_SPACE, true);
  robot.settle();
  const auto reference = robot.app().image().shown().values().image;
  EXPECT_NE(shown, reference);
  const auto frame = robot.workbench().sources(methods::reference, layers::image).frame;
  EXPECT_EQ(reference[100], frame->rendering().radiance[100] + frame->rendering().emission[100]);
  robot.hold(GLFW_KEY_SPACE, false);
  robot.settle();
  EXPECT_EQ(robot.app().image().shown().values().image, shown);
}

TEST(GuiView, ThresholdRendersAnew) {
  Robot robot(small_room());
  const auto cut_sizes = [&] {
    robot.settle();
    return robot.app().image().shown().coloured().statistics.mean;
  };
  robot.state().layer = layers::cut_size;
  robot.app().show(Tab::live);
  const double before = cut_sizes();
  // The slider at the top of the panel at the right: find it by its effect.
  const float threshold = *robot.state().shading.threshold;
  const ScreenArea area = robot.app().image().area();
  const double x = area.origin.x + area.size.x + 320;
  for (double y = 84; y < 400 && robot.state().shading.threshold == threshold; y += 8)
    robot.click({x, y});
  ASSERT_NE(robot.state().shading.threshold, threshold);
  ASSERT_TRUE(robot.state().shading.threshold);
  const double after = cut_sizes();
  EXPECT_NE(after, before);
  EXPECT_EQ(after > before, *robot.state().shading.threshold < threshold);
}

TEST(GuiView, BuilderMakesAnotherTree) {
  ViewState room = small_room();
  room.pixel = glm::uvec2(30, 20);
  Robot robot(room);
  robot.app().show(Tab::live);
  robot.frames(2);
  const auto before = robot.workbench().scene();
  ASSERT_EQ(before->request().builder, Builder::greedy);
  const ScreenArea area = robot.app().image().area();
  const double x = area.origin.x + area.size.x + 160;
  for (double y = 355; y < 500 && robot.state().open.builder == Builder::greedy; y += 8) {
    robot.click({x, y});
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) robot.click({x, y + 42});
  }
  ASSERT_EQ(robot.state().open.builder, Builder::locally_ordered);
  robot.settle();
  const auto after = robot.workbench().scene();
  ASSERT_NE(after, before);
  EXPECT_EQ(after->request().builder, Builder::locally_ordered);
  EXPECT_EQ(robot.state().shading, room.shading) << "nothing else was touched";
}

TEST(GuiView, SplitShowsTwoMethods) {
  ViewState state = small_room();
  state.split = true;
  state.compared = methods::reference;
  Robot robot(state);
  EXPECT_TRUE(robot.workbench().sources(methods::reference, layers::image).frame->complete());
  const ScreenArea area = robot.app().image().area();
  const glm::dvec2 on_line(area.origin.x + 0.5 * area.size.x, area.origin.y + 100);
  robot.drag(on_line, on_line + glm::dvec2(0.25 * area.size.x, 0));
  EXPECT_NEAR(robot.state().split_at, 0.75, 0.01);
  EXPECT_TRUE(robot.state().image.fits); // the line was dragged, not the image
}

TEST(GuiView, SplitHeatMapsHaveOneScale) {
  ViewState state = small_room();
  state.layer = layers::cut_size;
  state.split = true;
  state.compared = methods::paper;
  Robot robot(state);
  const Coloured& left = robot.app().image().shown().coloured();
  const Coloured& right = robot.app().image().compared().coloured();
  EXPECT_NE(left.statistics.largest, right.statistics.largest);
  EXPECT_EQ(left.scale, right.scale);
}

TEST(GuiView, CameraOrbitsByRasterAndIsThenTraced) {
  Robot robot(small_room());
  const Camera before = robot.workbench().camera();
  const auto picture = robot.app().image().shown().values().image;
  const glm::dvec2 from = robot.on_screen({30, 20});
  robot.move(from);
  robot.press_button(1);
  robot.move(from + glm::dvec2(60, 10));
  EXPECT_TRUE(robot.workbench().holds_pictures);
  robot.release_button(1);
  EXPECT_FALSE(robot.workbench().holds_pictures);
  EXPECT_NE(robot.workbench().camera(), before);
  robot.settle();
  EXPECT_NE(robot.app().image().shown().values().image, picture);
  robot.press('R');
  robot.settle();
  EXPECT_EQ(robot.workbench().camera(), before);
  EXPECT_EQ(robot.app().image().shown().values().image, picture);
}

TEST(GuiView, CameraStopsWhereFloatsEnd) {
  Robot robot(small_room());
  const glm::dvec2 at = robot.on_screen({30, 20});
  robot.hold(GLFW_KEY_LEFT_CONTROL, true);
  for (int i = 0; i < 20; ++i) robot.wheel(at, 10); // onto the target
  robot.hold(GLFW_KEY_LEFT_CONTROL, false);
  robot.drag(at, at + glm::dvec2(0, 240), 1); // would be upon it, or look along `up`
  robot.drag(at, at + glm::dvec2(-50, -400), 1);
  robot.settle();
  EXPECT_NO_THROW(PinholeView(robot.workbench().camera(), {4, 4}));
}

TEST(GuiView, QuestionMarkListsTheShortcuts) {
  Robot robot(small_room());
  const auto before = robot.screen().screenshot();
  robot.type("?");
  EXPECT_NE(robot.screen().screenshot(), before);
  robot.type("?");
  robot.frames(2);
  EXPECT_EQ(robot.screen().screenshot(), before);
}

TEST(GuiView, SurvivesBeingResizedToNothing) {
  Robot robot(small_room());
  for (const glm::uvec2 size : {glm::uvec2(0, 0), glm::uvec2(1, 1), glm::uvec2(40, 30),
                                glm::uvec2(2560, 1440), glm::uvec2(1280, 800)}) {
    robot.screen().resize(size);
    robot.frames(3);
  }
  robot.click(robot.on_screen({20, 30}));
  EXPECT_EQ(robot.state().pixel, glm::uvec2(20, 30));
}

} // namespace
} // namespace lightcuts::viz
