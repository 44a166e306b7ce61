// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace lightcuts {

/// Relative error of determinant_between(): 5 roundings of 2^-53, amplified at most 2^8 times.
inline constexpr double determinant_error = 0x1p-42;

/// det(a, y - x, b) for floats taken as exact reals, summed without error and rounded once. Slow.
[[nodiscard]] double exact_determinant(const glm::vec3& a, const glm::vec3& x, const glm::vec3& y,
                                       const glm::vec3& b);

/// det(a, y - x, b) within a relative error of determinant_error, zero and sign exact: a plain sum
/// in double, and the exact one where the terms cancel; see dot_between().
[[nodiscard]] inline double determinant_between(const glm::vec3& a, const glm::vec3& x,
                                                const glm::vec3& y, const glm::vec3& b) {
  // Products of two floats are exact: each part of b x a is rounded once, even where it cancels.
  const double p = (double(y.x) - x.x) * (double(b.y) * a.z - double(b.z) * a.y);
  const double q = (double(y.y) - x.y) * (double(b.z) * a.x - double(b.x) * a.z);
  const double r = (double(y.z) - x.z) * (double(b.x) * a.y - double(b.y) * a.x);
  const double sum = p + q + r;
  const double scale = std::abs(p) + std::abs(q) + std::abs(r);
  if (std::abs(sum) >= 0x1p-8 * scale) return sum;
  return exact_determinant(a, x, y, b);
}

} // namespace lightcuts
