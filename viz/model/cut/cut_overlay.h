// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/render/images/colour_map.h>

#include <viz/model/cut/cluster_row.h>
#include <viz/model/cut/overlay.h>

namespace lightcuts::viz {

/// By which quantity clusters are coloured.
enum class ClusterColour { error, bound, lights };

/// The quantity that is coloured: error and bound as scalar_of() has them, radiance; nothing where
/// it is not known.
[[nodiscard]] std::optional<double> coloured_value(const ClusterRow& row, ClusterColour by);

/// Logarithmic, up to the largest finite value of the rows and down to the smallest that is above
/// 0, but four decades at most; 1e-4 to 1 where there is none.
[[nodiscard]] HeatMapScale cluster_scale(std::span<const ClusterRow> rows, ClusterColour by);

/// The brighter part of heat_colour()'s map, to be seen on dark ground, and its colours for NaN and
/// infinity; unknown_colour without a value.
[[nodiscard]] Rgba8 cluster_colour(std::optional<double> value, const HeatMapScale& scale);

inline constexpr Rgba8 unknown_colour{128, 128, 128, 255};
inline constexpr Rgba8 selected_colour{60, 255, 90, 255};     ///< green, which the map has not
inline constexpr Rgba8 seen_colour{235, 235, 225, 110};       ///< of lines to lights that are seen
inline constexpr Rgba8 blocked_colour{255, 50, 40, 150};      ///< of lines to those that are not
inline constexpr Rgba8 proven_seen_colour{90, 215, 255, 110}; ///< where that is proven
inline constexpr Rgba8 proven_hidden_colour{200, 70, 255, 150}; ///< where that is proven
inline constexpr Rgba8 share_colour{255, 190, 60, 110};         ///< where a share is estimated
inline constexpr Rgba8 normal_colour{90, 170, 255, 255};        ///< of the arrow, and of the point

struct OverlayOptions {
  ClusterColour colour_by = ClusterColour::error; ///< default error
  std::optional<std::uint32_t> selected = {};     ///< a node, drawn on top; default none
  bool boxes = true;                              ///< of the clusters; default true
  bool lines = true;              ///< from the point to representatives; default true
  std::uint32_t most_boxes = 500; ///< those of the largest values; default 500
  float scene_diagonal = 1;       ///< metres, for the length of the normal; default 1
};

/// Of the line to a cluster's representative: by whether it is seen, and how that is known.
[[nodiscard]] Rgba8 line_colour(const ClusterRow& row);

/// The drawing of a cut: boxes of clusters (of those with some extent) coloured by their value,
/// lines to representatives, which are points, and the normal (unit, or 0 for none) as an arrow
/// from the shading point, metres. The selected cluster always has its box and its line.
[[nodiscard]] Overlay overlay_of(const glm::vec3& position, const glm::vec3& normal,
                                 std::span<const ClusterRow> rows, const OverlayOptions& options);

} // namespace lightcuts::viz
