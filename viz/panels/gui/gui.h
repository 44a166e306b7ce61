// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

struct ImGuiContext;

namespace lightcuts::viz {

/// ImGui with our fonts and colours, drawing by OpenGL. Made, used and destroyed where an OpenGL
/// context is current.
class Gui {
public:
  /// scale: of fonts and all sizes, 1 on an ordinary screen.
  explicit Gui(float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Without a window that would say: the size in pixels, and the time since the last frame. Sets
  /// keys up as GLFW has them.
  void set_screen(glm::uvec2 size, float seconds);
  /// After the backend of the window, if any, has begun its frame.
  void begin();
  /// Draws to the framebuffer that is bound, `size` pixels of it, over a dark ground.
  void end(glm::uvec2 size);

private:
  ImGuiContext* context_;
};

/// Letters of one width, for columns, until ImGui::PopFont().
void push_fixed_width();

} // namespace lightcuts::viz
