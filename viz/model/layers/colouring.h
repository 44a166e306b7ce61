// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/render/images/colour_map.h>

#include <viz/model/layers/colour_settings.h>
#include <viz/model/layers/layer_values.h>

namespace lightcuts::viz {

/// Colours of pixels of which nothing is known yet, and of those in a heat map that see no surface.
inline constexpr Rgb8 pending_colour{38, 38, 42}, nothing_colour{58, 58, 66};

/// A layer and the numbers that its legend shows.
struct Coloured {
  glm::uvec2 size{0};
  std::vector<Rgb8> pixels; ///< row by row from the top left
  LayerStatistics statistics;
  HeatMapScale scale; ///< of heat maps
  float exposure = 1; ///< of images
};

/// The scale of a heat map as chosen: automatic, or the range given.
[[nodiscard]] HeatMapScale scale_of(const ColourSettings& settings,
                                    const LayerStatistics& statistics);

/// exposure: of an image where none is chosen; nothing: its own automatic_exposure(). scale: of a
/// heat map, in place of scale_of(), as to compare two.
[[nodiscard]] Coloured coloured(Layer layer, const LayerValues& values,
                                const ColourSettings& settings,
                                std::optional<float> exposure = std::nullopt,
                                const std::optional<HeatMapScale>& scale = std::nullopt);

} // namespace lightcuts::viz
