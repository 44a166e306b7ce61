// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/numerics/angle.h>

namespace lightcuts {

/// All directions within an angle of an axis.
struct OrientationCone {
  glm::vec3 axis{0, 0, 1}; ///< about unit; its length is divided out
  float chord2 = 0; ///< squared chord of the half-angle, 2 - 2 cos, in [0, 4]: unlike the cosine,
                    ///< it keeps its digits where the cone is narrow

  /// The half-angle.
  [[nodiscard]] Angle half_angle() const {
    const double k = chord2;
    return {1 - 0.5 * k, std::sqrt(k * (1 - 0.25 * k))};
  }
};

/// A cone that contains both in real numbers, the narrowest but for rounding; all directions where
/// that has more than pi as its half-angle. Of equal axes: that axis, and the wider angle. No
/// operand gives NaN: opposite axes are enclosed around a perpendicular one.
[[nodiscard]] OrientationCone merged(const OrientationCone& a, const OrientationCone& b);

} // namespace lightcuts
