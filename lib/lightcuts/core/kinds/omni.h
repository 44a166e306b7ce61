// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/without_axis.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// intensity / d^2: alike in all directions.
struct Omni : WithoutAxis {
  static constexpr LightKind kind = LightKind::omni;

  /// What the second moment adds to n.q/|q|^3 at the centroid.
  static double second_moment_factor(const SecondMoment& second, const glm::vec3& normal,
                                     const ClusterEmission* /*emission*/) {
    return second.factor(normal, 3);
  }
};

} // namespace lightcuts
