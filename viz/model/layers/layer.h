// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace lightcuts::viz {

/// A quantity of each pixel.
enum class Layer {
  image,           ///< the picture
  cut_size,        ///< clusters summed, or lights where no tree is used
  shadow_rays,     ///< shadow rays cast
  error,           ///< true relative error
  certified_error, ///< relative error that is certified without knowing the truth
  slack,           ///< certified over true error
  time,            ///< microseconds
  clairvoyant,     ///< size of the smallest cut whose true errors are good enough
  violations       ///< properties that do not hold at the pixel
};
inline constexpr Layer all_layers[] = {Layer::image, Layer::cut_size,        Layer::shadow_rays,
                                       Layer::error, Layer::certified_error, Layer::slack,
                                       Layer::time,  Layer::clairvoyant,     Layer::violations};

struct LayerInfo {
  const char* name;    ///< of the command line
  const char* title;   ///< for people
  const char* unit;    ///< "" where it is a mere number
  const char* meaning; ///< what it says and its formula, one or two sentences
  bool whole_numbers;  ///< counts
};

[[nodiscard]] const LayerInfo& info(Layer layer);
[[nodiscard]] std::optional<Layer> layer_named(std::string_view name);

/// Whether the layer compares with the reference.
[[nodiscard]] constexpr bool needs_reference(Layer layer) {
  return layer == Layer::error || layer == Layer::slack;
}
/// Whether the layer needs the true contribution of every cluster at every pixel.
[[nodiscard]] constexpr bool needs_truth(Layer layer) {
  return layer == Layer::clairvoyant || layer == Layer::violations;
}

} // namespace lightcuts::viz
