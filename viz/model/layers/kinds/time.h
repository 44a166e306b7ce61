// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo time{
    .name = "time",
    .title = "Time",
    .unit = "us",
    .meaning = "Wall time of the pixel, microseconds; jobs beside it count.",
    .value = [](const LayerPixel& p) { return p.picture.microseconds[p.i]; }};

} // namespace lightcuts::viz::layers
