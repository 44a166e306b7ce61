// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <viz/panels/app/offscreen.h>

namespace lightcuts::viz {

/// A person at the window, which is drawn off-screen: real frames, with mouse and keys put in.
class Robot {
public:
  explicit Robot(const ViewState& state, glm::uvec2 size = {1280, 800},
                 const std::filesystem::path& output = {})
      : screen_(size, 1, {}, output) {
    app().workbench().state = state;
    settle();
  }

  [[nodiscard]] App& app() { return screen_.app(); }
  [[nodiscard]] Workbench& workbench() { return app().workbench(); }
  [[nodiscard]] ViewState& state() { return workbench().state; }
  [[nodiscard]] Offscreen& screen() { return screen_; }

  void frames(int count) {
    for (int i = 0; i < count; ++i) screen_.frame();
  }
  void settle(double seconds = 60) { EXPECT_TRUE(screen_.settle(seconds)); }

  void move(const glm::dvec2& to) {
    ImGui::GetIO().MousePos = {float(to.x), float(to.y)};
    frames(2);
  }
  void press_button(int button = 0) {
    ImGui::GetIO().MouseDown[button] = true;
    frames(2);
  }
  void release_button(int button = 0) {
    ImGui::GetIO().MouseDown[button] = false;
    frames(2);
  }
  void click(const glm::dvec2& at) {
    move(at);
    press_button();
    release_button();
  }
  void drag(const glm::dvec2& from, const glm::dvec2& to, int button = 0) {
    move(from);
    press_button(button);
    move(0.5 * (from + to));
    move(to);
    release_button(button);
  }
  void wheel(const glm::dvec2& at, float by) {
    move(at);
    ImGui::GetIO().MouseWheel = by;
    frames(1);
    ImGui::GetIO().MouseWheel = 0;
    frames(1);
  }
  /// key: of GLFW.
  void hold(int key, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[key] = down;
    if (key == GLFW_KEY_LEFT_SHIFT) io.KeyShift = down;
    if (key == GLFW_KEY_LEFT_CONTROL) io.KeyCtrl = down;
    frames(2);
  }
  void press(int key) {
    hold(key, true);
    hold(key, false);
  }
  void type(const std::string& text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  }

  /// Where the middle of a pixel of the image is on the screen.
  [[nodiscard]] glm::dvec2 on_screen(glm::uvec2 pixel) {
    return to_screen(app().image().view(), app().image().area(), glm::dvec2(pixel) + 0.5);
  }

private:
  Offscreen screen_;
};

/// A room of blocks, small enough for tests.
inline ViewState small_room() {
  ViewState state;
  state.open.spec = "cloud?lights=300&blocks=5&material=glossy";
  state.open.image_size = glm::uvec2(64, 48);
  state.shading.tree_use = TreeUse::always;
  state.shading.threshold = 0.02F;
  return state;
}

} // namespace lightcuts::viz
