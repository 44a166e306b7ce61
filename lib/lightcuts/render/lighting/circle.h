// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

namespace lightcuts {

/// Cosine and sine of `turns` full turns, within 2^-50, |turns| <= 2^20: the same bits everywhere,
/// which the C library's are not.
inline glm::dvec2 on_unit_circle(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  constexpr double quarter_turn = 1.5707963267948966;     // radians
  const double x = quarter_turn * (4 * turns - quarters); // in [-pi/4, pi/4]
  const double xx = x * x;
  // Taylor's series; the first term left out is below 2^-54 of the sum.
  double cosine = 1, sine = 1;
  for (int k = 16; k > 0; k -= 2) {
    cosine = 1 - cosine * xx / (k * (k - 1));
    sine = 1 - sine * xx / (k * (k + 1));
  }
  sine *= x;
  switch (static_cast<long>(quarters) & 3) {
  case 0:
    return {cosine, sine};
  case 1:
    return {-sine, cosine};
  case 2:
    return {-cosine, -sine};
  default:
    return {sine, -cosine};
  }
}

} // namespace lightcuts
