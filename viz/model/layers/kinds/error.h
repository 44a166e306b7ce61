// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <viz/model/layers/layer.h>

namespace lightcuts::viz::layers {

/// The sum over RGB of |v - r|.
[[nodiscard]] inline double true_error(const LayerPixel& p) {
  const glm::vec3& v = p.picture.radiance[p.i];
  const glm::vec3& r = p.reference->radiance[p.i];
  // Both beyond the largest float: equal, as far as can be told.
  double sum = 0;
  for (int c = 0; c < 3; ++c)
    if (v[c] != r[c]) sum += std::abs(double(v[c]) - double(r[c]));
  return sum;
}

inline constexpr LayerInfo error{
    .name = "error",
    .title = "True error",
    .unit = "relative",
    .meaning = "How far the pixel v is from the reference r: sum over RGB of |v - r| / max(sum r, "
               "3 black level).",
    .needs = LayerNeeds::reference,
    .value = [](const LayerPixel& p) {
      return relative_error(p, true_error(p), p.reference->radiance[p.i]);
    }};

} // namespace lightcuts::viz::layers
