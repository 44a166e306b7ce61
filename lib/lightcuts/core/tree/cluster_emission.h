// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/geometry/orientation_cone.h>
#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {

struct TreeNode;

/// Where the oriented lights or spots of a cluster shine.
struct ClusterEmission {
  OrientationCone cone;      ///< has all their axes, in real numbers
  glm::vec3 mean_axis{0};    ///< mean of the unit axes, weighted by intensity; not unit
  glm::vec3 axis_square{0};  ///< mean of the products of their components: xx, yy, zz
  glm::vec3 axis_product{0}; ///< yz, zx, xy
  float cos_inner = 1;       ///< of spots: the least of each
  float cos_outer = 1;
};

/// For all nodes, in one bottom-up pass; nodes as LightTree has them.
[[nodiscard]] std::vector<ClusterEmission> emission_of(std::span<const TreeNode> nodes,
                                                       const LightSet& lights);

namespace detail {

// More than the angles below err by; a positive result has a least value, beside which that is less
// than 2^-24.
inline constexpr double emission_slack = 8 * angle_error;
inline constexpr double least_cosine = 0x1p-20;
inline constexpr double least_ramp = 0x1p-10;

/// t^2 of a ramp that begins at cos_outer; see LightKind::spot.
inline double ramp2(const ClusterEmission& e, double cosine) {
  const double t = (cosine - e.cos_outer) / (double(e.cos_inner) - e.cos_outer);
  return t >= 1 ? 1 : t * t;
}

} // namespace detail

/// Upper bound of emission() towards x over lights whose positions are in the box. With psi the
/// least angle between the cone's axis and x - y, y in the box, and beta the cone's half-angle, the
/// angle between any light's axis and the direction towards x is at least psi - beta. emission()
/// falls with that angle, and falls the less the smaller cos_inner and cos_outer are.
/// A cluster that ends at the horizon within 2^-40 may count as reaching above it.
[[nodiscard]] inline double max_emission(LightKind kind, const ClusterEmission& e,
                                         const glm::vec3& x, const Box& box) {
  const Angle psi = min_angle(-e.cone.axis, x, box);
  const double cosine = difference(psi, e.cone.half_angle()).cos;
  if (kind == LightKind::oriented) {
    if (cosine < -0x1p-40) return 0;
    return std::clamp(cosine + detail::emission_slack, detail::least_cosine, 1.0);
  }
  if (cosine + 0x1p-40 < e.cos_outer) return 0;
  return std::max(detail::ramp2(e, std::max(cosine + detail::emission_slack, double(e.cos_outer))),
                  detail::least_ramp * detail::least_ramp);
}

/// Lower bound of the same, by the largest angle psi + beta; 0 for spots.
[[nodiscard]] inline double min_emission(LightKind kind, const ClusterEmission& e,
                                         const glm::vec3& x, const Box& box) {
  if (kind == LightKind::spot) return 0;
  const Angle farthest = supplement(min_angle(e.cone.axis, x, box));
  return std::max(0.0, sum(farthest, e.cone.half_angle()).cos - detail::emission_slack);
}

namespace detail {

/// Mean of max(0, cos) over axes whose cosine with the unit direction d has the mean and the
/// variance that the moments give, as if it were spread evenly over an interval: exact for equal
/// axes, where all face d, and for axes in all directions alike.
inline double mean_facing(const ClusterEmission& e, const glm::dvec3& d, double mean) {
  const glm::dvec3 s(e.axis_square), p(e.axis_product);
  const double square = s.x * d.x * d.x + s.y * d.y * d.y + s.z * d.z * d.z +
                        2 * (p.x * d.y * d.z + p.y * d.z * d.x + p.z * d.x * d.y);
  const double half_width = std::sqrt(3 * std::max(0.0, square - mean * mean));
  if (mean >= half_width) return mean;
  if (mean <= -half_width) return 0;
  return (mean + half_width) * (mean + half_width) / (4 * half_width);
}

} // namespace detail

/// Mean of emission() over a cluster of oriented lights as if they were at y: exact to first order
/// where all face x, a guess within [0, 1] elsewhere.
[[nodiscard]] inline double mean_emission(const ClusterEmission& e, const glm::vec3& y,
                                          const glm::vec3& x) {
  const glm::dvec3 way = glm::dvec3(x) - glm::dvec3(y);
  const double length2 = glm::dot(way, way);
  if (length2 == 0) return 0;
  const glm::dvec3 d = way / std::sqrt(length2);
  const double mean = glm::dot(glm::dvec3(e.mean_axis), d);
  return std::clamp(detail::mean_facing(e, d, mean), 0.0, 1.0);
}

} // namespace lightcuts
