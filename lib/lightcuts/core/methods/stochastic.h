// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/lighter_by_draws.h>

namespace lightcuts::methods {

inline constexpr MethodDescription stochastic{
    .name = "stochastic",
    .meaning = "One light drawn for each cluster of a cut, by hierarchical importance: unbiased.",
    .draws = true,
    .cuts = true,
    .rules = {},
    .lighter = LighterByDraws<HierarchicalImportance>::make};

} // namespace lightcuts::methods
