// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <lightcuts/render/lighting/circle.h>

namespace lightcuts {

/// A unit vector perpendicular to `axis`, which is unit.
inline glm::dvec3 perpendicular(const glm::dvec3& axis) {
  // Crossed with the coordinate axis that it is farthest from.
  const glm::dvec3 size = glm::abs(axis);
  const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                           : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(axis, other));
}

/// The vector of length `radius` perpendicular to the unit vector `axis`, `turns` about it.
inline glm::dvec3 about(const glm::dvec3& axis, double radius, double turns) {
  const glm::dvec3 x = perpendicular(axis);
  const glm::dvec2 on_circle = radius * on_unit_circle(turns);
  return on_circle.x * x + on_circle.y * glm::cross(axis, x);
}

/// The unit vector at this cosine to the unit vector `axis`, `turns` about it.
inline glm::dvec3 at_cosine(const glm::dvec3& axis, double cosine, double turns) {
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  return cosine * axis + about(axis, sine, turns);
}

/// Maps the unit square to directions about a unit normal, of density cosine / pi.
inline glm::dvec3 square_to_cosine(const glm::dvec3& normal, const glm::dvec2& u) {
  return at_cosine(normal, std::sqrt(1 - u.x), u.y);
}

} // namespace lightcuts
