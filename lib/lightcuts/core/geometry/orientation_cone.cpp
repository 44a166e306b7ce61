// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/orientation_cone.h>

#include <algorithm>

#include <lightcuts/core/numerics/rounding.h>

namespace lightcuts {
namespace {

/// Makes up for the rounding of the angles that are added up below.
constexpr double slack = 4 * angle_error;

/// An upper bound of the squared chord.
float chord2_above(const Angle& angle) {
  // 2 - 2 cos = 2 sin^2 / (1 + cos), which does not cancel where the angle is small.
  const double sin = angle.sin + slack;
  const double chord2 = angle.cos > 0 ? 2 * sin * sin / (1 + angle.cos) : 2 - 2 * angle.cos + slack;
  return std::min(4.0F, round_up(chord2 * (1 + 0x1p-40)));
}

/// Of a cone around `axis` that contains `inner`.
float chord2_around(const glm::vec3& axis, const OrientationCone& inner) {
  if (axis == inner.axis) return inner.chord2;
  return chord2_above(sum(angle_between(axis, inner.axis), inner.half_angle()));
}

glm::dvec3 perpendicular(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  if (size.x <= size.y && size.x <= size.z) return {0, -v.z, v.y};
  if (size.y <= size.z) return {-v.z, 0, v.x};
  return {-v.y, v.x, 0};
}

/// Between the axes such that the cones' outer rims are equally far away.
glm::vec3 axis_between(const OrientationCone& a, const OrientationCone& b, const Angle& between) {
  const glm::dvec3 u = glm::normalize(glm::dvec3(a.axis)), v = glm::normalize(glm::dvec3(b.axis));
  const Angle turn = half(difference(sum(between, b.half_angle()), a.half_angle()));
  const Angle rest = difference(between, turn);
  glm::dvec3 axis = rest.sin * u + turn.sin * v;
  // Opposite axes: any way round will do.
  if (!(glm::dot(axis, axis) > 0x1p-60)) axis = perpendicular(u);
  return glm::vec3(glm::normalize(axis));
}

} // namespace

OrientationCone merged(const OrientationCone& a, const OrientationCone& b) {
  const float around_a = std::max(a.chord2, chord2_around(a.axis, b));
  const float around_b = std::max(b.chord2, chord2_around(b.axis, a));
  const OrientationCone best =
      around_b < around_a ? OrientationCone{b.axis, around_b} : OrientationCone{a.axis, around_a};
  // One contains the other, or they fill all directions.
  if (best.chord2 == std::max(a.chord2, b.chord2)) return best;
  const glm::vec3 axis = axis_between(a, b, angle_between(a.axis, b.axis));
  const float chord2 = std::max(chord2_around(axis, a), chord2_around(axis, b));
  return chord2 < best.chord2 ? OrientationCone{axis, chord2} : best;
}

} // namespace lightcuts
