// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/without_axis.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// intensity, whatever the distance: so far away that all its rays are parallel.
struct Directional : WithoutAxis {
  static constexpr LightKind kind = LightKind::directional;

  /// What the second moment adds to n.q/|q| at the centroid.
  static double second_moment_factor(const SecondMoment& second, const glm::vec3& normal,
                                     const ClusterEmission* /*emission*/) {
    return second.factor(normal, 1);
  }
};

} // namespace lightcuts
