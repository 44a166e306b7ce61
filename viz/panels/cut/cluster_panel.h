// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include <viz/model/cut/cluster_row.h>
#include <viz/model/cut/cluster_table.h>

namespace lightcuts::viz {

/// The clusters that the table shows.
struct ClusterContents {
  std::span<const ClusterRow> rows;
  std::uint64_t revision = 0;                 ///< another number whenever the rows have changed
  std::optional<std::uint32_t> selected = {}; ///< a node; default none
};

/// The rows shown, as long as nothing of what they depend on changes.
struct ClusterOrder {
  std::string filter, error;
  ClusterColumn column = ClusterColumn::node;
  bool descending = false;
  std::uint64_t revision = 0;
  std::size_t of = 0; ///< rows there are
  std::vector<std::uint32_t> rows;
};

/// State of the table that stays from frame to frame.
struct ClusterPanelState {
  std::string filter;                           ///< see read_filter(); default empty
  ClusterColumn column = ClusterColumn::share;  ///< by which it is sorted at first; default share
  bool descending = true;                       ///< default true
  std::optional<std::uint32_t> shown_selection; ///< to see that it has changed
  std::optional<ClusterOrder> order;
};

struct ClusterEvents {
  std::optional<std::uint32_t> clicked, hovered; ///< nodes
};

/// Draws the rows as a table, with a filter above. Scrolls to a cluster that is selected elsewhere.
/// size in pixels; 0: all there is room for.
ClusterEvents draw_clusters(const char* id, const ClusterContents& contents,
                            ClusterPanelState& state, ImVec2 size);

} // namespace lightcuts::viz
