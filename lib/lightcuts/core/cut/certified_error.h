// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <lightcuts/core/numerics/rounding.h>

namespace lightcuts {

/// Relative error of a sum of estimates apart from that of clustering: transfer(), the intensities
/// of the tree (2^-53 per level), their sum, and the last rounding to float.
inline constexpr double estimate_error = 0x1p-23;

/// Upper bound of |to_float(total) - exact| for one channel, where total >= 0 is a sum of estimates
/// in double and bounds the sum of their error bounds. At least 2^-149; +inf where to_float(total)
/// is.
[[nodiscard]] inline float certified_error(double total, double bounds) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  if (to_float(total) == infinite) return infinite;
  // 2^-149: rounding of a subnormal total, and what underflows in transfer(), even where the total
  // is 0; 2^-30: rounding of the sum of bounds.
  const double rounding = total * estimate_error + 0x1p-149;
  return round_up((bounds + rounding) * (1 + 0x1p-30));
}

} // namespace lightcuts
