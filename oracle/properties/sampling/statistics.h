// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace lightcuts::oracle {

/// A random number of which mean, variance and range are known: what is tested is a mean of many.
struct Spread {
  double variance = 0;
  double range = 0; ///< largest distance from the mean
};

/// The share of a false-alarm rate that each of so many independent tests may have:
///   1 - (1 - rate)^(1/tests)    (Sidak 1967)
[[nodiscard]] double sidak(double rate, std::uint64_t tests);

/// Deviation of the mean of n draws from its expectation that is exceeded, to either side together,
/// with a probability of at most `rate`. Bernstein's inequality,
///   P(|mean - expectation| >= t) <= 2 exp(-n t^2 / (2 variance + 2 range t / 3)) ,
/// which holds for every distribution and every n, solved for t.
[[nodiscard]] double bernstein_deviation(const Spread& spread, std::uint64_t n, double rate);

/// Draws after which a bias of so much is overlooked with a probability of at most `overlooked` by
/// a test of that false-alarm rate, if the biased draws spread no more than the right ones: so many
/// that the two deviations sum to no more than the bias. Nothing if that is more than `most`.
[[nodiscard]] std::optional<std::uint64_t> draws_to_notice(double bias, const Spread& spread,
                                                           double rate, double overlooked,
                                                           std::uint64_t most);

} // namespace lightcuts::oracle
