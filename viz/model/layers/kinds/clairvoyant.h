// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>
#include <viz/model/picture/truth_picture.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo clairvoyant{
    .name = "clairvoyant",
    .title = "Clairvoyant cut",
    .unit = "clusters",
    .meaning = "The smallest cut whose clusters' true errors are all at most max(threshold x true "
               "total, black level): what a perfect bound would get by with.",
    .whole_numbers = true,
    .needs = LayerNeeds::truth,
    .value = [](const LayerPixel& p) { return p.truth->clairvoyant()[p.i]; }};

} // namespace lightcuts::viz::layers
