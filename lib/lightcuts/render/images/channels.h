// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/vec3.hpp>

namespace lightcuts {

/// What is said to be the power of a coloured light, and decides how many samples it gets.
inline double mean(const glm::dvec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }

inline double largest(const glm::dvec3& rgb) { return std::max({rgb.x, rgb.y, rgb.z}); }

/// Rec. 709.
inline double luminance(const glm::dvec3& rgb) {
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

} // namespace lightcuts
