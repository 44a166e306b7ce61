// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/numerics/angle.h>
#include <lightcuts/core/tree/cluster_emission.h>

namespace lightcuts::detail {

// More than the angles below err by; a positive result has a least value, beside which that is less
// than 2^-24.
inline constexpr double emission_slack = 8 * angle_error;

/// Cosine of the least angle between any axis of the cluster and -q, the way back to what is lit.
/// With psi the least angle between the cone's axis and -q, and beta the cone's half-angle, it is
/// at least psi - beta.
[[nodiscard]] inline double max_axis_cosine(const ClusterEmission& e, const DifferenceBox& q) {
  return difference(min_angle(-e.cone.axis, q), e.cone.half_angle()).cos;
}

/// Cosine of the largest such angle, psi + beta.
[[nodiscard]] inline double min_axis_cosine(const ClusterEmission& e, const DifferenceBox& q) {
  return sum(supplement(min_angle(e.cone.axis, q)), e.cone.half_angle()).cos;
}

} // namespace lightcuts::detail
