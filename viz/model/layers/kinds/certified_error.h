// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo certified_error{
    .name = "certified-error",
    .title = "Certified error",
    .unit = "relative",
    .meaning = "What the error cannot exceed, known without a reference: sum over RGB of the "
               "certified error / max(sum v, 3 black level).",
    .value = [](const LayerPixel& p) {
      return relative_error(p, sum_of_channels(p.picture.certified_error[p.i]),
                            p.picture.radiance[p.i]);
    }};

} // namespace lightcuts::viz::layers
