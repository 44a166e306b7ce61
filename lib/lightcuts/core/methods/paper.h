// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription paper{
    .name = "paper",
    .meaning = "Lightcuts as published: product bound, random representative, scaled.",
    .draws = false,
    .cuts = true,
    .rules = {BoundRule::product, EstimateRule::representative},
    .lighter = [](const LighterConfig& config) { return lighter_by_cuts(config, paper.rules); }};

} // namespace lightcuts::methods
