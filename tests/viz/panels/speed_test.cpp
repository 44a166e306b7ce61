// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <thread>

#include <gtest/gtest.h>

#include <lightcuts/core/jobs/seconds_since.h>
#include <tests/viz/support/gui_robot.h>
#include <viz/panels/app/frame_pacer.h>

namespace lightcuts::viz {
namespace {

/// Median time of a frame, milliseconds, while somebody moves the mouse.
double frame_milliseconds(Robot& robot, int frames) {
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) {
    ImGui::GetIO().MousePos = {300.0F + float(i), 200.0F + float(i % 50)};
    const auto start = Clock::now();
    robot.frames(1);
    robot.screen().finish();
    times.push_back(1000 * seconds_since(start));
  }
  std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
  return times[std::size_t(frames) / 2];
}

// Lax limits: machines differ, and tests run beside each other. The numbers are printed.
TEST(GuiSpeed, TreeOfAMillionLights) {
  ViewState state;
  state.open.spec = "cloud?lights=1000000";
  state.open.image_size = glm::uvec2(32, 24);
  Robot robot(ViewState{}, {1280, 800});
  robot.state() = state;
  robot.settle(180);
  const double idle = frame_milliseconds(robot, 60);
  const auto start = Clock::now();
  robot.click(robot.on_screen({16, 14}));
  while (!robot.workbench().inspection() && seconds_since(start) < 10) robot.frames(1);
  ASSERT_TRUE(robot.workbench().inspection());
  const double to_cut = seconds_since(start);
  const std::size_t clusters = robot.workbench().inspection()->inspection.clusters.size();
  const double with_cut = frame_milliseconds(robot, 60);
  std::printf("[ measured ] 10^6 lights, 1280 x 800: frame %.1f ms, with a cut of %zu %.1f ms; "
              "cut picked in %.1f ms, shown within %.0f ms of the click, frames of the click "
              "included\n",
              idle, clusters, with_cut, 1000 * robot.workbench().inspection()->seconds,
              1000 * to_cut);
  EXPECT_LT(with_cut, 250);
  EXPECT_LT(robot.workbench().inspection()->seconds, 0.5);
  robot.settle(120);
}

TEST(GuiSpeed, FramesWhileARenderRuns) {
  ViewState state;
  state.open.spec = "cloud?lights=20000";
  Robot robot(ViewState{}, {1280, 800});
  robot.state() = state;
  const auto start = Clock::now();
  // Drawing without a pause would take the processor from what is waited for.
  while (!robot.workbench().scene() && seconds_since(start) < 60) {
    robot.frames(1);
    std::this_thread::sleep_for(std::chrono::duration<double>(FramePacer::busy));
  }
  robot.frames(3);
  ASSERT_TRUE(robot.workbench().current_picture());
  const double during = frame_milliseconds(robot, 90);
  ASSERT_TRUE(robot.workbench().current_picture());
  std::printf("[ measured ] frame while a picture is rendered: %.1f ms (%.0f a second)\n", during,
              1000 / during);
  EXPECT_LT(during, 250);
}

TEST(GuiSpeed, FirstImageAndFullFrame) {
  ViewState state;
  state.open.spec = "bedroom";
  Robot robot(ViewState{}, {1280, 800});
  robot.state() = state;
  const auto start = Clock::now();
  double first = 0;
  const auto values = [&]() -> const LayerValues& { return robot.app().image().shown().values(); };
  while (seconds_since(start) < 60) {
    robot.frames(1);
    const auto& known = values().known;
    if (first == 0 && !known.empty() &&
        std::all_of(known.begin(), known.end(), [](char k) { return k != 0; }))
      first = seconds_since(start);
    if (robot.app().settled() && first > 0) break;
    // As the window does while nobody touches it.
    std::this_thread::sleep_for(std::chrono::duration<double>(FramePacer::busy));
  }
  const double full = seconds_since(start);
  std::printf("[ measured ] bedroom 640 x 480: first whole image after %.2f s, full one after "
              "%.2f s\n",
              first, full);
  ASSERT_GT(first, 0);
  EXPECT_LT(first, 5);
  EXPECT_LT(full, 60);
}

} // namespace
} // namespace lightcuts::viz
