// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>
#include <viz/model/picture/block_picture.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo block_size{
    .name = "block-size",
    .title = "Block size",
    .unit = "pixels",
    .meaning = "Pixels that go down the tree together with this one, itself among them; 1 where it "
               "stands alone.",
    .whole_numbers = true,
    .needs = LayerNeeds::blocks,
    .value = [](const LayerPixel& p) { return p.blocks->block_size()[p.i]; }};

} // namespace lightcuts::viz::layers
