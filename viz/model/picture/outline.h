// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace lightcuts::viz {

/// An edge of a pixel, between two of its corners, in pixels from the picture's upper left.
struct PixelEdge {
  glm::uvec2 from, to;
  bool operator==(const PixelEdge&) const = default;
};

/// The edges between these pixels and all others, pixel by pixel.
[[nodiscard]] std::vector<PixelEdge> outline_of(std::span<const glm::uvec2> pixels);

} // namespace lightcuts::viz
