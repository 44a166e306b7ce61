// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "gl/gl_objects.h"

namespace lightcuts::viz {

/// How much something stands out.
enum class Weight : std::uint8_t {
  thin,   ///< lines 1 pixel wide, points 3
  normal, ///< lines 2 pixels wide, points 6
  thick   ///< lines 3.5 pixels wide, points 10
};

/// A segment in the world.
struct ColouredLine {
  glm::vec3 from{0}, to{0}; ///< metres
  Rgba8 colour{255};
  Weight weight = Weight::normal;
};

/// A round point in the world.
struct ColouredPoint {
  glm::vec3 position{0}; ///< metres
  Rgba8 colour{255};
  Weight weight = Weight::normal;
};

/// What the 3D view draws over the scene.
struct Overlay {
  std::vector<ColouredLine> lines;
  std::vector<ColouredPoint> points;
};

} // namespace lightcuts::viz
