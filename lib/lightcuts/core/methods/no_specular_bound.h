// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription no_specular_bound{
    .name = "no-specular-bound",
    .meaning = "Lightcuts whose glossy lobes are bounded by their peaks: larger cuts.",
    .draws = false,
    .cuts = true,
    .rules = {BoundRule::no_specular, EstimateRule::centroid},
    .lighter = [](const LighterConfig& config) {
      return lighter_by_cuts(config, no_specular_bound.rules);
    }};

} // namespace lightcuts::methods
