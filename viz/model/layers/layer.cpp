// SPDX-License-Identifier: MIT
#include <viz/model/layers/layer.h>

#include <array>
#include <cstddef>
#include <iterator>

namespace lightcuts::viz {

const LayerInfo& info(Layer layer) {
  static constexpr std::array<LayerInfo, std::size(all_layers)> infos{{
      {"image", "Image", "", "Radiance that is reflected and emitted towards the camera.", false},
      {"cut-size", "Lights evaluated", "clusters",
       "Clusters of the pixel's cut, each lit by one light; all lights where no tree is used.",
       true},
      {"shadow-rays", "Shadow rays", "rays", "Rays cast to find out what light is seen.", true},
      {"error", "True error", "relative",
       "How far the pixel v is from the reference r: sum over RGB of |v - r| / max(sum r, 3 black "
       "level).",
       false},
      {"certified-error", "Certified error", "relative",
       "What the error cannot exceed, known without a reference: sum over RGB of the certified "
       "error / max(sum v, 3 black level).",
       false},
      {"slack", "Slack", "ratio",
       "Certified error / true error, at least 1; 0 where the pixel has no error.", false},
      {"time", "Time", "us", "Wall time of the pixel, microseconds; jobs beside it count.", false},
      {"clairvoyant", "Clairvoyant cut", "clusters",
       "The smallest cut whose clusters' true errors are all at most max(threshold x true total, "
       "black level): what a perfect bound would get by with.",
       true},
      {"violations", "Violations", "cases",
       "Properties of bounds and cuts that do not hold at the pixel, judged by the oracle. Of the "
       "library: 0.",
       true},
  }};
  return infos[std::size_t(layer)];
}

std::optional<Layer> layer_named(std::string_view name) {
  for (const Layer layer : all_layers)
    if (name == info(layer).name) return layer;
  return std::nullopt;
}

} // namespace lightcuts::viz
