// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription unscaled{
    .name = "unscaled",
    .meaning = "The paper's cut, its representatives not scaled to their clusters: too dark.",
    .draws = false,
    .cuts = true,
    .rules = {BoundRule::product, EstimateRule::unscaled},
    .lighter = [](const LighterConfig& config) { return lighter_by_cuts(config, unscaled.rules); }};

} // namespace lightcuts::methods
