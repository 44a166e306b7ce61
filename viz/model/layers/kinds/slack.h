// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/layers/kinds/error.h>

namespace lightcuts::viz::layers {

inline constexpr LayerInfo slack{
    .name = "slack",
    .title = "Slack",
    .unit = "ratio",
    .meaning = "Certified error / true error, at least 1; 0 where the pixel has no error.",
    .needs = LayerNeeds::reference,
    .value = [](const LayerPixel& p) {
      const double e = true_error(p);
      return e == 0 ? 0 : float(sum_of_channels(p.picture.certified_error[p.i]) / e);
    }};

} // namespace lightcuts::viz::layers
