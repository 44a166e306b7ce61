// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// Shares `count` samples out in proportion to the weights (finite, > 0), at least one to each: the
/// sum of the result is the larger of `count` and the number of weights. A share differs from the
/// proportional one by less than 1 unless that is below 1.
[[nodiscard]] std::vector<std::uint32_t> apportion(std::span<const double> weights,
                                                   std::uint32_t count);

/// Draws `count` samples from the weights (finite, >= 0, not all 0), one from each of as many equal
/// pieces of their sum: how often each weight was drawn. Expected: in proportion to the weights.
[[nodiscard]] std::vector<std::uint32_t> draw_stratified(std::span<const double> weights,
                                                         std::uint32_t count, Random random);

} // namespace lightcuts
