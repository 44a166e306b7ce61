// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// Hammersley's points in the unit square (i/n, the bits of i mirrored at the binary point), moved
/// around it by a random shift (Cranley & Patterson 1976): spread evenly, each uniform by itself.
class Hammersley {
public:
  Hammersley(std::uint32_t count, Random random) : count_(count) {
    for (int axis = 1; axis >= 0; --axis) shift_[axis] = random.unit_double();
  }

  /// Point i of [0, count), each coordinate in [0, 1).
  [[nodiscard]] glm::dvec2 operator[](std::uint32_t i) const {
    const double y = mirrored(i) + shift_.y;
    // A shift close to 1 may round the last point up to 1.
    const double x = (i + shift_.x) / count_;
    return {x < 1 ? x : 0x1.fffffffffffffp-1, y < 1 ? y : y - 1};
  }

private:
  static double mirrored(std::uint32_t bits) {
    double sum = 0;
    for (double digit = 0.5; bits != 0; bits >>= 1, digit *= 0.5)
      if ((bits & 1U) != 0) sum += digit;
    return sum;
  }

  std::uint32_t count_;
  glm::dvec2 shift_;
};

} // namespace lightcuts
