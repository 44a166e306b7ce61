// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>

#include <tests/viz/support/gui_robot.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using Pixels = std::vector<Rgb8>;

/// Mean difference of two pictures over their channels, of 255.
double difference(const Pixels& a, const Pixels& b) {
  EXPECT_EQ(a.size(), b.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c) sum += std::abs(int(a[i][c]) - int(b[i][c]));
  return sum / (3.0 * double(a.size()));
}

/// Rounding of 8 bits, and a line or two of the window over the picture.
constexpr double same = 0.1;

/// What the window shows of the image, one screen pixel per pixel.
Pixels image_on_screen(Robot& robot) {
  robot.press('1');
  robot.settle();
  robot.move({2, 2}); // off the image: no tooltip
  const Pixels screen = robot.screen().screenshot();
  const glm::uvec2 size = robot.workbench().scene()->scene().image_size;
  const glm::dvec2 lo = to_screen(robot.app().image().view(), robot.app().image().area(), {0, 0});
  Pixels image;
  for (unsigned y = 0; y < size.y; ++y)
    for (unsigned x = 0; x < size.x; ++x)
      image.push_back(screen[std::size_t(std::lround(lo.y + y)) * robot.screen().size().x +
                             std::size_t(std::lround(lo.x + x))]);
  return image;
}

/// What it should show, from a rendering of the library's and heat_colour(). scale: 0 to the
/// largest.
Pixels expected_heat(const std::vector<float>& values) {
  const float most = *std::max_element(values.begin(), values.end());
  Pixels pixels;
  for (const float v : values) pixels.push_back(heat_colour(v, {0, most, false}));
  return pixels;
}

Rendering rendered(Robot& robot, Method method, float threshold) {
  const OpenedScene& scene = *robot.workbench().scene();
  const CutConfig cut{threshold, default_max_cut, scene.black_level()};
  return render(scene.view(), *scene.tree(), {.method = method, .cut = cut});
}

ViewState fixed_range(Layer layer) {
  ViewState state = small_room();
  state.layer = layer;
  state.open.image_size = glm::uvec2(96, 64);
  return state;
}

void show_whole_range(Robot& robot, const std::vector<float>& values) {
  ColourSettings& colours = robot.state().colours;
  colours.automatic_range = false;
  colours.lo = 0;
  colours.hi = *std::max_element(values.begin(), values.end());
}

TEST(GuiScreens, HeatMapIsThatOfTheRendering) {
  Robot robot(fixed_range(layers::cut_size));
  const Rendering right = rendered(robot, methods::lightcuts, 0.02F);
  show_whole_range(robot, right.cut_size);
  const Pixels shown = image_on_screen(robot);
  EXPECT_LT(difference(shown, expected_heat(right.cut_size)), same);
}

TEST(GuiScreens, MetricTellsAWrongHeatMap) {
  Robot robot(fixed_range(layers::cut_size));
  const Rendering right = rendered(robot, methods::lightcuts, 0.02F);
  show_whole_range(robot, right.cut_size);
  const Pixels shown = image_on_screen(robot);
  // Another threshold, another quantity, the picture moved by a pixel.
  const Rendering other = rendered(robot, methods::lightcuts, 0.03F);
  EXPECT_GT(difference(shown, expected_heat(other.cut_size)), 4 * same);
  EXPECT_GT(difference(shown, expected_heat(right.shadow_rays)), 4 * same);
  Pixels moved = expected_heat(right.cut_size);
  std::rotate(moved.begin(), moved.begin() + 1, moved.end());
  EXPECT_GT(difference(shown, moved), 4 * same);
}

TEST(GuiScreens, ImageIsThatOfTheRendering) {
  Robot robot(fixed_range(layers::image));
  robot.state().colours.exposure = 2;
  const auto expected = [&](Method method) {
    const Rendering r = rendered(robot, method, 0.02F);
    Pixels pixels;
    for (std::size_t i = 0; i < r.radiance.size(); ++i)
      pixels.push_back(srgb8(2.0F * (r.radiance[i] + r.emission[i])));
    return pixels;
  };
  EXPECT_LT(difference(image_on_screen(robot), expected(methods::lightcuts)), same);
  robot.state().display = methods::unscaled;
  robot.settle();
  EXPECT_LT(difference(image_on_screen(robot), expected(methods::unscaled)), same);
  EXPECT_GT(difference(image_on_screen(robot), expected(methods::lightcuts)), 4 * same);
}

TEST(GuiScreens, EveryTabAndLayerIsDrawn) {
  Robot robot(small_room());
  robot.click(robot.on_screen({20, 30}));
  robot.settle();
  std::vector<Pixels> seen;
  const auto expect_new = [&](const char* what) {
    robot.settle();
    robot.frames(2);
    const Pixels now = robot.screen().screenshot();
    for (const Pixels& before : seen) EXPECT_GT(difference(now, before), 0.05) << what;
    seen.push_back(now);
  };
  for (const Tab tab : {Tab::cut, Tab::why, Tab::scene, Tab::plots, Tab::live}) {
    robot.app().show(tab);
    robot.frames(2);
    expect_new("tab");
  }
  for (const Layer layer : all_layers) {
    if (layer == layers::image) continue;
    robot.state().layer = layer;
    expect_new(layer->name);
  }
}

} // namespace
} // namespace lightcuts::viz
