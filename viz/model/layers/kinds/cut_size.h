// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo cut_size{
    .name = "cut-size",
    .title = "Lights evaluated",
    .unit = "clusters",
    .meaning =
        "Clusters of the pixel's cut, each lit by one light; all lights where no tree is used.",
    .whole_numbers = true,
    .value = [](const LayerPixel& p) { return p.picture.cut_size[p.i]; }};

} // namespace lightcuts::viz::layers
