// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/render/images/colour_map.h>

#include <viz/gl/context/gl_objects.h>
#include <viz/gl/context/offscreen_context.h>
#include <viz/panels/app/app.h>
#include <viz/panels/gui/gui.h>

namespace lightcuts::viz {

/// The very same window without a screen.
class Offscreen {
public:
  /// Throws GlError where there is no OpenGL 3.3.
  Offscreen(glm::uvec2 size, float scale, AppSettings settings, std::filesystem::path output);

  [[nodiscard]] App& app() { return app_; }
  [[nodiscard]] glm::uvec2 size() const { return size_; }
  void resize(glm::uvec2 size) { size_ = size; }

  /// One frame; ImGui's mouse and keys are as the caller has set them. Nothing for a size of 0.
  void frame(float seconds = 1.0F / 60);
  /// Frames until all that is asked for is shown, or so many seconds are over; returns whether it
  /// is.
  bool settle(double seconds);
  /// Waits until OpenGL has drawn the last frame; for measurements.
  void finish() const;
  /// The last frame, row by row from the top.
  [[nodiscard]] std::vector<Rgb8> screenshot() const;

private:
  glm::uvec2 size_;
  OffscreenContext context_;
  Framebuffer screen_;
  Gui gui_;
  App app_;
};

} // namespace lightcuts::viz
