// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

namespace lightcuts {

/// Rounds x to float, upwards where `side` > 0, downwards where `side` < 0, else to the nearest.
inline float rounded_towards(double x, double side) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto nearest = static_cast<float>(x);
  if (side > 0 && nearest < x) return std::nextafter(nearest, infinity);
  if (side < 0 && nearest > x) return std::nextafter(nearest, -infinity);
  return nearest;
}

/// A point of a surface with normal n, rounded so that it does not fall behind the surface.
inline glm::vec3 rounded_towards(const glm::dvec3& p, const glm::dvec3& n) {
  return {rounded_towards(p.x, n.x), rounded_towards(p.y, n.y), rounded_towards(p.z, n.z)};
}

} // namespace lightcuts
