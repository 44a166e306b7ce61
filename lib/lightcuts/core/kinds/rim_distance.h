// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/towards.h>

namespace lightcuts::detail {

/// cos(axis, x - position) - rim, relative error 2^-40, in exact arithmetic; both have the same
/// sign, and neither is 0. Slow.
[[nodiscard]] double exact_rim_distance(const glm::vec3& axis, const glm::vec3& position,
                                        const glm::vec3& x, float rim);

/// cosine - rim, relative error 2^-33, zero and sign exact; cosine is that of axis_cosine().
[[nodiscard]] inline double rim_distance(const glm::vec3& axis, const glm::vec3& position,
                                         const glm::vec3& x, double cosine, float rim) {
  // The cosine errs by 2^-50; where that is too much for the difference:
  const double distance = cosine - rim;
  if (std::abs(distance) < 0x1p-17 && cosine * rim > 0) [[unlikely]]
    return exact_rim_distance(axis, position, x, rim);
  return distance;
}

} // namespace lightcuts::detail
