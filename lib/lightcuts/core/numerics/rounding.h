// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lightcuts {

/// The float nearest to value >= 0; +inf where value exceeds the largest float.
[[nodiscard]] inline float to_float(double value) {
  if (value > double(std::numeric_limits<float>::max()))
    return std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

/// The smallest float that is not below value >= 0: +inf above the largest one, and never 0 unless
/// value is 0.
[[nodiscard]] inline float round_up(double value) {
  const float nearest = to_float(value);
  const std::uint32_t below = double(nearest) < value ? 1 : 0; // a branch would often go wrong
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(nearest) + below);
}

/// The largest finite float that is not above value >= 0.
[[nodiscard]] inline float round_down(double value) {
  if (value >= double(std::numeric_limits<float>::max())) return std::numeric_limits<float>::max();
  const float nearest = static_cast<float>(value);
  if (double(nearest) <= value) return nearest;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(nearest) - 1);
}

/// Relative error of power() for exponents up to Material::max_exponent and a base whose own
/// relative error is below 2^-51: (2 + 4) m 2^-53.
inline constexpr double power_error = 0x1p-30;

/// base^exponent for base, exponent >= 0, by multiplications and square roots only: the same bits
/// with every compiler and C library, and monotone in base because each step rounds monotonically.
/// Values below 10^-308 underflow.
[[nodiscard]] inline double power(double base, float exponent) {
  auto whole = static_cast<std::uint32_t>(exponent);
  float fraction = exponent - static_cast<float>(whole);
  double result = 1;
  for (double square = base; whole != 0; whole >>= 1, square *= square)
    if ((whole & 1U) != 0) result *= square;
  for (double root = base; fraction > 0;) {
    root = std::sqrt(root);
    fraction *= 2;
    if (fraction >= 1) {
      result *= root;
      fraction -= 1;
    }
  }
  return result;
}

} // namespace lightcuts
