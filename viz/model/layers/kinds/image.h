// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo image{.name = "image",
                                 .title = "Image",
                                 .unit = "",
                                 .meaning =
                                     "Radiance that is reflected and emitted towards the camera.",
                                 .colour = [](const LayerPixel& p) {
                                   return p.picture.radiance[p.i] + p.picture.emission[p.i];
                                 }};

} // namespace lightcuts::viz::layers
