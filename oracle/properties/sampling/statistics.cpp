// SPDX-License-Identifier: MIT
#include <oracle/properties/sampling/statistics.h>

#include <cmath>

namespace lightcuts::oracle {

double sidak(double rate, std::uint64_t tests) {
  // 1 - (1 - rate)^(1/tests) without cancellation.
  return -std::expm1(std::log1p(-rate) / double(tests));
}

double bernstein_deviation(const Spread& spread, std::uint64_t n, double rate) {
  // n t^2 - (2/3) L range t - 2 L variance = 0,  L = log(2 / rate)
  const double l = std::log(2 / rate) / double(n);
  const double half = l * spread.range / 3;
  return half + std::sqrt(half * half + 2 * l * spread.variance);
}

std::optional<std::uint64_t> draws_to_notice(double bias, const Spread& spread, double rate,
                                             double overlooked, std::uint64_t most) {
  const auto suffice = [&](std::uint64_t n) {
    return bernstein_deviation(spread, n, rate) + bernstein_deviation(spread, n, overlooked) <=
           bias;
  };
  if (!suffice(most)) return std::nullopt;
  std::uint64_t few = 0, enough = most;
  while (enough - few > 1) {
    const std::uint64_t middle = few + (enough - few) / 2;
    (suffice(middle) ? enough : few) = middle;
  }
  return enough;
}

} // namespace lightcuts::oracle
