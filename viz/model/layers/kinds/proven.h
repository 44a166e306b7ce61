// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>
#include <viz/model/picture/block_picture.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo proven{
    .name = "proven",
    .title = "Proven visibility",
    .unit = "share",
    .meaning = "Share of the light, by the estimates, for which shafts have proven without a ray "
               "that it is seen or that it is hidden, 0 to 1; what is hidden counts as if it were "
               "seen.",
    .needs = LayerNeeds::blocks,
    .value = [](const LayerPixel& p) { return p.blocks->proven()[p.i]; }};

} // namespace lightcuts::viz::layers
