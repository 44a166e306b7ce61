// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/numerics/exact_dot.h>

namespace lightcuts {

/// Relative error of emission(): its zero is exact.
inline constexpr double emission_error = 0x1p-30;

namespace detail {

/// cos(axis, x - y) - cos_outer, relative error 2^-40, in exact arithmetic; both have the same
/// sign.
[[nodiscard]] double exact_rim_distance(const Light& light, const glm::vec3& x);

} // namespace detail

/// The share of its intensity that a light sends towards x; see LightKind. In [0, 1]; a light
/// exactly at x sends 0 unless it is an omni light.
[[nodiscard]] inline double emission(const Light& light, const glm::vec3& x) {
  if ((only(light.kind) & kinds_with_axis) == 0) return 1;
  const double dot = dot_between(light.axis, light.position, x);
  double squared_length = 0, axis2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = double(x[i]) - light.position[i];
    squared_length += d * d;
    axis2 += double(light.axis[i]) * light.axis[i];
  }
  if (squared_length == 0) return 0;
  const double cosine = dot / std::sqrt(squared_length * axis2);
  if (light.kind == LightKind::oriented) return std::clamp(cosine, 0.0, 1.0);
  // The cosine errs by 2^-50; where that is too much for the difference:
  double rim = cosine - light.cos_outer;
  if (std::abs(rim) < 0x1p-17 && cosine * light.cos_outer > 0)
    rim = detail::exact_rim_distance(light, x);
  const double t = std::clamp(rim / (double(light.cos_inner) - light.cos_outer), 0.0, 1.0);
  return t * t;
}

} // namespace lightcuts
