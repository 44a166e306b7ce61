// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/lighter_by_draws.h>

namespace lightcuts::methods {

inline constexpr MethodDescription stochastic_intensity{
    .name = "stochastic-intensity",
    .meaning = "One light drawn for each cluster of a cut, by intensity: unbiased, with noise.",
    .draws = true,
    .cuts = true,
    .rules = {},
    .lighter = LighterByDraws<IntensityImportance>::make};

} // namespace lightcuts::methods
