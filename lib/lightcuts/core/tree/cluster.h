// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/geometry/box.h>

namespace lightcuts {

/// What the metric needs to know of a cluster.
struct Cluster {
  Box box;
  Box axes{glm::vec3(0), glm::vec3(0)}; ///< of the lights' axes times sqrt(c)/4, c the diagonal of
                                        ///< the box of all lights; a point where they have none
  double weight = 0;                    ///< intensity summed over lights and channels
  std::uint32_t id = 0;   ///< lowest index of its lights: unlike an order of merging, a fact
  std::uint32_t node = 0; ///< where the caller keeps the rest of it
};

/// Cost of the union of two clusters: weight (diagonal^2 + c^2 (1 - cos beta)^2), beta being the
/// half-angle of a cone around the axes. A box around such axes has about the squared diagonal
/// 16 (1 - cos beta), which takes its place here: boxes merge without any rounding, cones do not.
/// Monotone, rounding included: growing either cluster never lowers it.
[[nodiscard]] inline double union_cost(const Cluster& a, const Cluster& b) {
  const double spread = squared_diagonal_of_union(a.axes, b.axes);
  return (a.weight + b.weight) * (squared_diagonal_of_union(a.box, b.box) + spread * spread);
}

} // namespace lightcuts
