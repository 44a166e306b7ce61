// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/difference_box.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_emission.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// intensity share / d^2, share as of ProfileTable: a luminaire by its measured table.
struct Luminaire {
  static constexpr LightKind kind = LightKind::profile;

  static double emission(const Light& light, const glm::vec3& x) {
    return emission_from(light, light.position, x);
  }

  /// Of lights in one frame the largest share over the vertical and the horizontal angles that q
  /// has, each range widened by 2^-23.6; over more than 256 cells of the table or a quarter turn,
  /// and of lights in several frames, that of the envelope over the vertical angles.
  static double max_emission(const ClusterEmission& e, const DifferenceBox& q);
  static double min_emission(const ClusterEmission& /*e*/, const DifferenceBox& /*q*/) { return 0; }

  /// Lights in one frame shine as if all were at the centroid, others as their representative does.
  static double mean_emission(const ClusterEmission& e, const Light& representative,
                              const glm::vec3& centroid, const glm::vec3& x) {
    return emission_from(representative, e.profile->one_frame ? centroid : representative.position,
                         x);
  }
  static double second_moment_factor(const SecondMoment& /*second*/, const glm::vec3& /*normal*/,
                                     const ClusterEmission* /*emission*/) {
    return 1;
  }

private:
  /// emission() of the light if it were at `position`.
  static double emission_from(const Light& light, const glm::vec3& position, const glm::vec3& x);
};

} // namespace lightcuts
