// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription lightcuts{
    .name = "lightcuts",
    .meaning = "Lightcuts: joint bound, estimates at the centroid of intensity.",
    .draws = false,
    .cuts = true,
    .rules = {},
    .lighter = [](const LighterConfig& config) {
      return config.use_tree ? lighter_by_cuts(config, config.rules) : lighter_by_sums(config);
    }};

} // namespace lightcuts::methods
