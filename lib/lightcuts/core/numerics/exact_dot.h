// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace lightcuts {

/// Relative error of dot_between(): 4 roundings of 2^-53, amplified at most 2^16 times.
inline constexpr double dot_error = 0x1p-35;

/// n.(y - x) for floats taken as exact reals, summed without error and rounded once. Slow.
[[nodiscard]] double exact_dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y);

/// n.(y - x) within a relative error of dot_error, zero and sign exact. A plain sum in double, and
/// the exact one where the terms cancel more than so many bits: a filter after Shewchuk, "Adaptive
/// Precision Floating-Point Arithmetic" (1997). With fewer bits the error is less by as many.
template <int most_cancelled_bits = 16>
[[nodiscard]] inline double dot_between(const glm::vec3& n, const glm::vec3& x,
                                        const glm::vec3& y) {
  constexpr double least_left = 1.0 / (1 << most_cancelled_bits);
  const double a = n.x * (double(y.x) - x.x);
  const double b = n.y * (double(y.y) - x.y);
  const double c = n.z * (double(y.z) - x.z);
  const double sum = a + b + c;
  const double scale = std::abs(a) + std::abs(b) + std::abs(c);
  if (std::abs(sum) >= least_left * scale) [[likely]]
    return sum;
  return exact_dot(n, x, y);
}

} // namespace lightcuts
