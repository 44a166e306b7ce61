// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <imgui.h>

#include <viz/gl/context/gl_objects.h>

namespace lightcuts::viz {

/// What is selected is drawn in this, wherever it is.
inline constexpr ImU32 selection_colour = IM_COL32(60, 255, 90, 255);
inline constexpr ImU32 violation_colour = IM_COL32(255, 70, 70, 255);
inline const ImVec4 violation_text{1, 0.4F, 0.4F, 1};
inline const ImVec4 quiet_text{0.62F, 0.63F, 0.68F, 1};

[[nodiscard]] inline ImVec2 to_imgui(const glm::dvec2& v) { return {float(v.x), float(v.y)}; }
[[nodiscard]] inline glm::dvec2 to_dvec(const ImVec2& v) { return {v.x, v.y}; }

/// As ImGui's OpenGL backend takes it.
[[nodiscard]] inline ImTextureID texture_id(const Texture2D& texture) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): a pointer is what ImGui takes
  return reinterpret_cast<ImTextureID>(std::uintptr_t(texture.id()));
}

/// A text on a dark ground, its upper left corner at the place.
void draw_label(const ImVec2& at, const char* text);

/// A tooltip for the last item, of at most some forty letters a line.
void tooltip(const char* text);

} // namespace lightcuts::viz
