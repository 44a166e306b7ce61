// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lightcuts::viz {

/// An 8-bit sRGB colour with its opacity.
using Rgba8 = glm::vec<4, std::uint8_t>;

struct ColouredLine {
  glm::vec3 a{0}, b{0}; ///< its ends in the world, metres
  Rgba8 colour{255};
  float width = 2; ///< pixels
};

struct ColouredPoint {
  glm::vec3 at{0}; ///< in the world, metres
  Rgba8 colour{255};
  float size = 6; ///< diameter, pixels
};

/// Lines and points that are drawn over a picture of the scene, in order: later ones lie on top.
struct Overlay {
  std::vector<ColouredLine> lines;
  std::vector<ColouredPoint> points;
};

} // namespace lightcuts::viz
