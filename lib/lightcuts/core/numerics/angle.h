// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// An angle in [0, pi] by cosine and sine: exact arithmetic on both needs square roots only, so
/// that it gives the same bits everywhere, and neither small angles nor those near pi lose digits.
struct Angle {
  double cos = 1, sin = 0;
};

/// Error, either way, of cosine and sine after any one of the operations below on exact operands,
/// or on results of one other.
inline constexpr double angle_error = 0x1p-49;

/// Between n and q, any lengths but 0 whose squares neither overflow nor underflow.
[[nodiscard]] inline Angle angle_between(const glm::dvec3& n, const glm::dvec3& q) {
  const double inverse = 1 / std::sqrt(glm::dot(n, n) * glm::dot(q, q));
  const glm::dvec3 cross = glm::cross(n, q);
  return {std::clamp(glm::dot(n, q) * inverse, -1.0, 1.0),
          std::min(std::sqrt(glm::dot(cross, cross)) * inverse, 1.0)};
}

/// min(a + b, pi).
[[nodiscard]] inline Angle sum(const Angle& a, const Angle& b) {
  if (a.cos + b.cos <= 0) return {-1, 0};
  return {a.cos * b.cos - a.sin * b.sin, std::max(0.0, a.sin * b.cos + a.cos * b.sin)};
}

/// max(a - b, 0).
[[nodiscard]] inline Angle difference(const Angle& a, const Angle& b) {
  if (a.cos >= b.cos) return {};
  return {a.cos * b.cos + a.sin * b.sin, std::max(0.0, a.sin * b.cos - a.cos * b.sin)};
}

[[nodiscard]] inline Angle half(const Angle& a) {
  if (a.cos >= 0) {
    const double cos = std::sqrt(0.5 * (1 + a.cos));
    return {cos, 0.5 * a.sin / cos};
  }
  const double sin = std::sqrt(0.5 * (1 - a.cos));
  return {0.5 * a.sin / sin, sin};
}

/// pi - a.
[[nodiscard]] inline Angle supplement(const Angle& a) { return {-a.cos, a.sin}; }

} // namespace lightcuts
