// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>
#include <viz/model/picture/truth_picture.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo violations{
    .name = "violations",
    .title = "Violations",
    .unit = "cases",
    .meaning = "Properties of bounds and cuts that do not hold at the pixel, judged by the oracle. "
               "Of the library: 0.",
    .whole_numbers = true,
    .none = "no violation",
    .needs = LayerNeeds::truth,
    .value = [](const LayerPixel& p) { return p.truth->violations()[p.i]; }};

} // namespace lightcuts::viz::layers
