// SPDX-License-Identifier: MIT
#include <viz/panels/app/offscreen.h>

#include <algorithm>
#include <thread>
#include <utility>

#include <lightcuts/core/jobs/seconds_since.h>
#include <viz/gl/context/opengl.h>

namespace lightcuts::viz {

Offscreen::Offscreen(glm::uvec2 size, float scale, AppSettings settings,
                     std::filesystem::path output)
    : size_(size), screen_({TexelFormat::rgba8}, false), gui_(scale),
      app_(std::move(settings), std::move(output)) {}

void Offscreen::frame(float seconds) {
  if (size_.x == 0 || size_.y == 0) return;
  screen_.resize(size_);
  gui_.set_screen(size_, seconds);
  gui_.begin();
  app_.frame();
  screen_.bind();
  gui_.end(size_);
}

bool Offscreen::settle(double seconds) {
  const auto start = Clock::now();
  // What a frame asks for is seen in the next one; some things of ImGui take two. Frames by
  // software take the processor from what they wait for: a few are enough.
  int quiet = 0;
  std::chrono::milliseconds pause(2);
  while (quiet < 4 && seconds_since(start) < seconds) {
    frame();
    quiet = app_.settled() ? quiet + 1 : 0;
    // What is rasterised is made by frames themselves.
    if (quiet == 0 && app_.image().raster_complete()) std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(64));
  }
  return quiet >= 4;
}

void Offscreen::finish() const { glFinish(); }

std::vector<Rgb8> Offscreen::screenshot() const {
  std::vector<Rgb8> pixels;
  for (const Rgba8& p : screen_.read_rgba8(0)) pixels.emplace_back(p.r, p.g, p.b);
  return pixels;
}

} // namespace lightcuts::viz
