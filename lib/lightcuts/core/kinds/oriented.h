// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/cone_bounds.h>
#include <lightcuts/core/kinds/towards.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// intensity max(0, cos theta) / d^2: a piece of a surface, a VPL.
struct Oriented {
  static constexpr LightKind kind = LightKind::oriented;

  static double emission(const Light& light, const glm::vec3& x) {
    return std::clamp(detail::axis_cosine(light, x).cosine, 0.0, 1.0);
  }

  static double max_emission(const ClusterEmission& e, const DifferenceBox& q) {
    constexpr double least_cosine = 0x1p-20;
    const double cosine = detail::max_axis_cosine(e, q);
    if (cosine < -0x1p-40) return 0;
    return std::clamp(cosine + detail::emission_slack, least_cosine, 1.0);
  }
  static double min_emission(const ClusterEmission& e, const DifferenceBox& q) {
    return std::max(0.0, detail::min_axis_cosine(e, q) - detail::emission_slack);
  }

  /// Mean of emission() over a cluster as if all were at the centroid: exact to first order where
  /// all face x, a guess within [0, 1] elsewhere.
  static double mean_emission(const ClusterEmission& e, const Light& /*representative*/,
                              const glm::vec3& centroid, const glm::vec3& x) {
    const glm::dvec3 way = glm::dvec3(x) - glm::dvec3(centroid);
    const double length2 = glm::dot(way, way);
    if (length2 == 0) return 0;
    const glm::dvec3 d = way / std::sqrt(length2);
    const double mean = glm::dot(glm::dvec3(e.mean_axis), d);
    return std::clamp(mean_facing(e, d, mean), 0.0, 1.0);
  }

  /// What the second moment adds to n.q a.q/|q|^4, a the mean axis.
  static double second_moment_factor(const SecondMoment& second, const glm::vec3& normal,
                                     const ClusterEmission* emission) {
    return second.oriented_factor(normal, emission->mean_axis);
  }

private:
  /// Mean of max(0, cos) over axes whose cosine with the unit direction d has the mean and the
  /// variance that the moments give, as if it were spread evenly over an interval: exact for equal
  /// axes, where all face d, and for axes in all directions alike.
  static double mean_facing(const ClusterEmission& e, const glm::dvec3& d, double mean) {
    const glm::dvec3 s(e.axis_square), p(e.axis_product);
    const double square = s.x * d.x * d.x + s.y * d.y * d.y + s.z * d.z * d.z +
                          2 * (p.x * d.y * d.z + p.y * d.z * d.x + p.z * d.x * d.y);
    const double half_width = std::sqrt(3 * std::max(0.0, square - mean * mean));
    if (mean >= half_width) return mean;
    if (mean <= -half_width) return 0;
    return (mean + half_width) * (mean + half_width) / (4 * half_width);
  }
};

} // namespace lightcuts
