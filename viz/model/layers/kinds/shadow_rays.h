// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo shadow_rays{
    .name = "shadow-rays",
    .title = "Shadow rays",
    .unit = "rays",
    .meaning = "Rays cast to find out what light is seen.",
    .whole_numbers = true,
    .value = [](const LayerPixel& p) { return p.picture.shadow_rays[p.i]; }};

} // namespace lightcuts::viz::layers
