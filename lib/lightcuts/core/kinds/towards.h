// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/numerics/exact_dot.h>

namespace lightcuts {

/// Relative error of a kind's emission(): its zero is exact.
inline constexpr double emission_error = 0x1p-30;

namespace detail {

/// cos(axis, x - y) of a light at y, errs by 2^-50; defined where y is not x.
struct AxisCosine {
  double cosine = 0;
  bool defined = false;
};

[[nodiscard]] inline AxisCosine axis_cosine(const glm::vec3& axis, const glm::vec3& y,
                                            const glm::vec3& x) {
  const double dot = dot_between(axis, y, x);
  double squared_length = 0, axis2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = double(x[i]) - y[i];
    squared_length += d * d;
    axis2 += double(axis[i]) * axis[i];
  }
  if (squared_length == 0) return {};
  return {dot / std::sqrt(squared_length * axis2), true};
}
[[nodiscard]] inline AxisCosine axis_cosine(const Light& light, const glm::vec3& x) {
  return axis_cosine(light.axis, light.position, x);
}

} // namespace detail
} // namespace lightcuts
