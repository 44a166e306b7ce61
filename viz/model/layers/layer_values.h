// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/images/colour_map.h>

#include <viz/model/layers/layer.h>
#include <viz/model/picture/block_picture.h>
#include <viz/model/picture/frame.h>
#include <viz/model/picture/truth_picture.h>

namespace lightcuts::viz {

/// The pictures that a layer is computed from: the frame, and where the layer needs them the
/// reference, the truth and the blocks, of the same scene, camera and size.
struct LayerSources {
  std::shared_ptr<const Frame> frame;
  std::shared_ptr<const Frame> reference;
  std::shared_ptr<const TruthPicture> truth;
  std::shared_ptr<const BlockPicture> blocks = nullptr;

  /// The picture that alone makes the layer, beside the frame's settings; null where it is made of
  /// the frame.
  [[nodiscard]] const Picture* instead_of_frame(Layer layer) const {
    if (layer.needs_truth()) return truth.get();
    return layer.needs_blocks() ? blocks.get() : nullptr;
  }
};

/// A layer as far as it is known, row by row from the top left.
struct LayerValues {
  glm::uvec2 size{0};
  std::vector<glm::vec3> image; ///< of a layer that is one
  std::vector<float> values;    ///< of any other layer
  std::vector<char> known;      ///< per pixel, whether it, or one in its stead, is
  std::vector<char> own;        ///< per pixel, whether it is known itself
  std::vector<char> surface;    ///< per pixel, whether it sees one
};

/// Grows when layer_values() would give more.
[[nodiscard]] std::uint64_t version_of(Layer layer, const LayerSources& sources);

[[nodiscard]] LayerValues layer_values(Layer layer, const LayerSources& sources);

/// Of one pixel, of a layer that is no image: its value, if it is known itself and sees a surface.
[[nodiscard]] std::optional<float> layer_value(Layer layer, const LayerSources& sources,
                                               glm::uvec2 pixel);

/// Numbers of what is known of a layer at pixels that see a surface.
struct LayerStatistics {
  std::uint64_t known = 0, nan = 0, infinite = 0;
  float least = 0, largest = 0; ///< of the finite ones
  float least_positive = 0;     ///< 0: there is none
  float most_below = 0;         ///< 99.5 % of the finite ones are at most this
  double mean = 0;              ///< of the finite ones
};
[[nodiscard]] LayerStatistics statistics_of(const LayerValues& layer);

/// The scale that shows it: from 0, or from the least positive value if logarithmic, to the largest
/// value; where a few are far above the others, to LayerStatistics::most_below, so that these can
/// be told apart.
[[nodiscard]] HeatMapScale automatic_scale(const LayerStatistics& statistics, bool logarithmic);

} // namespace lightcuts::viz
