// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

/// Of maps from the unit square to directions, about a normal (0, 0, 1).
namespace lightcuts::oracle::density {

inline constexpr double pi = std::numbers::pi;

/// The direction at these cylindrical coordinates around the z axis.
inline glm::dvec3 around_z(double cosine, double angle) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

/// tan^2 of the angle between h, of any length, and the z axis.
inline double tangent2(const glm::dvec3& h) { return (h.x * h.x + h.y * h.y) / (h.z * h.z); }

inline glm::dvec3 mirrored(const glm::dvec3& v, const glm::dvec3& h) {
  return 2 * glm::dot(v, h) * h - v;
}

inline glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

} // namespace lightcuts::oracle::density
