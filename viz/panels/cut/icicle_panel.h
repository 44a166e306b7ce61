// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <imgui.h>

#include <viz/model/cut/cluster_row.h>
#include <viz/model/cut/icicle.h>
#include <viz/model/cut/overlay.h>

namespace lightcuts::viz {

/// The tree and cut that an icicle shows.
struct IcicleContents {
  const Icicle& icicle;
  const oracle::Topology& tree; ///< the icicle's
  const IcicleCut& cut;
  std::uint32_t cut_size = 0;                 ///< its clusters
  std::optional<std::uint32_t> selected = {}; ///< a node; default none
  std::optional<std::uint32_t> hovered = {};  ///< a node, by the mouse elsewhere; default none
  /// Of a node's block; nothing, or no function: by its place above, in or below the cut.
  std::function<std::optional<Rgba8>(std::uint32_t node)> colour = {};
  /// A node as seen from the shading point, for the tooltip; default none.
  std::function<std::optional<ClusterRow>(std::uint32_t node)> row = {};
};

/// State of the icicle that stays from frame to frame.
struct IciclePanelState {
  IcicleView view{.row_height = 18};
  float dragged = 0;                            ///< pixels down that do not make a row yet
  std::optional<std::uint32_t> shown_selection; ///< to see that it has changed
};

struct IcicleEvents {
  std::optional<std::uint32_t> clicked, hovered; ///< nodes
};

/// Draws the icicle with a legend on top. The wheel zooms at the mouse (scrolls with Shift),
/// dragging moves, a double click shows all. Goes to a node that is selected elsewhere, where it
/// cannot be seen. size in pixels; 0: all there is room for.
IcicleEvents draw_icicle(const char* id, const IcicleContents& contents, IciclePanelState& state,
                         ImVec2 size);

} // namespace lightcuts::viz
