// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/cone_bounds.h>
#include <lightcuts/core/kinds/rim_distance.h>
#include <lightcuts/core/kinds/towards.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// intensity t^2 / d^2, t = (cos theta - cos_outer) / (cos_inner - cos_outer) clamped to [0, 1]: a
/// cone with a soft rim, as in glTF's KHR_lights_punctual.
struct Spot {
  static constexpr LightKind kind = LightKind::spot;

  static double emission(const Light& light, const glm::vec3& x) {
    const detail::AxisCosine towards = detail::axis_cosine(light, x);
    if (!towards.defined) return 0;
    const double rim =
        detail::rim_distance(light.axis, light.position, x, towards.cosine, light.cos_outer);
    const double t = std::clamp(rim / (double(light.cos_inner) - light.cos_outer), 0.0, 1.0);
    return t * t;
  }

  /// emission() falls with the angle to the axis, and falls the less the smaller cos_inner and
  /// cos_outer are. A cluster that ends at the rim within 2^-40 may count as shining.
  static double max_emission(const ClusterEmission& e, const DifferenceBox& q) {
    constexpr double least_ramp = 0x1p-10;
    const double cosine = detail::max_axis_cosine(e, q);
    if (cosine + 0x1p-40 < e.cos_outer) return 0;
    return std::max(ramp2(e, std::max(cosine + detail::emission_slack, double(e.cos_outer))),
                    least_ramp * least_ramp);
  }
  static double min_emission(const ClusterEmission& /*e*/, const DifferenceBox& /*q*/) { return 0; }

  /// A mean of spots says little of any; they shine as their representative does.
  static double mean_emission(const ClusterEmission& /*e*/, const Light& representative,
                              const glm::vec3& /*centroid*/, const glm::vec3& x) {
    return emission(representative, x);
  }
  static double second_moment_factor(const SecondMoment& /*second*/, const glm::vec3& /*normal*/,
                                     const ClusterEmission* /*emission*/) {
    return 1;
  }

private:
  /// t^2 of a ramp that begins at cos_outer.
  static double ramp2(const ClusterEmission& e, double cosine) {
    const double t = (cosine - e.cos_outer) / (double(e.cos_inner) - e.cos_outer);
    return t >= 1 ? 1 : t * t;
  }
};

} // namespace lightcuts
