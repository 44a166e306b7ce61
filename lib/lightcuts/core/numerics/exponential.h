// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace lightcuts {

/// Relative error of exp_of_minus(), its argument taken as exact.
inline constexpr double exponential_error = 0x1p-48;

/// e^-t for t >= 0, by additions and multiplications only: the same bits with every compiler and C
/// library. 0 for t > 700.
[[nodiscard]] inline double exp_of_minus(double t) {
  if (!(t <= 700)) return 0;
  // t = k ln 2 - r, |r| <= ln(2)/2; ln 2 in two parts, so that k times the first is exact.
  constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  constexpr double per_ln2 = 0x1.71547652b82fep+0;
  const auto k =
      static_cast<std::int64_t>(0.5 + per_ln2 * t); // NOLINT(bugprone-incorrect-roundings)
  const double r = (double(k) * ln2_high - t) + double(k) * ln2_low;
  double sum = 1;
  for (int i = 14; i >= 1; --i) sum = 1 + sum * r / i;
  return sum * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - k) << 52);
}

} // namespace lightcuts
