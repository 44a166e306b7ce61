// SPDX-License-Identifier: MIT
#include <viz/model/cut/cut_overlay.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include <viz/model/cut/cluster_table.h>

namespace lightcuts::viz {
namespace {

constexpr float thin = 1, thick = 3;          // lines, pixels
constexpr float small_dot = 4, large_dot = 9; // points, pixels
constexpr float arrow_length = 0.05F;         // of the scene's diagonal
constexpr double decades = 1e4;               // that colours tell apart
constexpr float darkest = 0.25F;              // of the map, seen on dark ground

glm::vec3 corner(const Box& box, int i) {
  return {(i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
          (i & 4) != 0 ? box.hi.z : box.lo.z};
}

void add_box(const Box& box, const Rgba8& colour, float width, Overlay& out) {
  for (int axis = 1; axis <= 4; axis *= 2)
    for (int i = 0; i < 8; ++i)
      if ((i & axis) == 0)
        out.lines.push_back({corner(box, i), corner(box, i | axis), colour, width});
}

/// A shaft with four barbs.
void add_arrow(const glm::vec3& from, const glm::vec3& direction, Overlay& out) {
  const glm::vec3 tip = from + direction;
  out.lines.push_back({from, tip, normal_colour, thick});
  const glm::vec3 other = std::abs(direction.x) < 0.5F * glm::length(direction)
                              ? glm::vec3(1, 0, 0)
                              : glm::vec3(0, 1, 0);
  const glm::vec3 u = glm::normalize(glm::cross(direction, other)) * glm::length(direction);
  const glm::vec3 v = glm::cross(direction, u) / glm::length(direction);
  for (const glm::vec3& side : {u, -u, v, -v})
    out.lines.push_back({tip, tip - 0.2F * direction + 0.08F * side, normal_colour, thick});
}

void add_representative(const glm::vec3& from, const ClusterRow& row, bool selected, Overlay& out) {
  const glm::vec3& to = row.representative_position;
  if (row.representative == oracle::TreeClaim::unsaid) return;
  Rgba8 colour = line_colour(row);
  if (selected) colour.a = 255;
  out.lines.push_back({from, to, colour, selected ? thick : thin});
  colour.a = 255;
  out.points.push_back({to, selected ? selected_colour : colour, selected ? large_dot : small_dot});
}

bool has_extent(const ClusterRow& row) { return row.has_box && row.box.lo != row.box.hi; }

/// The rows of the largest values that have boxes to draw, the largest last and so on top.
std::vector<std::uint32_t> rows_with_boxes(std::span<const ClusterRow> rows,
                                           const OverlayOptions& options) {
  using Keyed = std::pair<double, std::uint32_t>;
  std::vector<Keyed> order;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    const double value = coloured_value(rows[i], options.colour_by).value_or(-1);
    if (has_extent(rows[i]) && rows[i].node != options.selected)
      order.emplace_back(std::isnan(value) ? std::numeric_limits<double>::infinity() : value, i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Keyed& a, const Keyed& b) { return a.first > b.first; });
  order.resize(std::min<std::size_t>(order.size(), options.most_boxes));
  std::reverse(order.begin(), order.end());
  std::vector<std::uint32_t> result;
  result.reserve(order.size());
  for (const Keyed& entry : order) result.push_back(entry.second);
  return result;
}

void add_boxes(std::span<const ClusterRow> rows, const OverlayOptions& options, Overlay& out) {
  const HeatMapScale scale = cluster_scale(rows, options.colour_by);
  for (const std::uint32_t i : rows_with_boxes(rows, options))
    add_box(rows[i].box, cluster_colour(coloured_value(rows[i], options.colour_by), scale), thin,
            out);
}

} // namespace

std::optional<double> coloured_value(const ClusterRow& row, ClusterColour by) {
  switch (by) {
  case ClusterColour::error:
    return scalar_of(row, ClusterColumn::error);
  case ClusterColour::bound:
    return scalar_of(row, ClusterColumn::bound);
  case ClusterColour::lights:
    return scalar_of(row, ClusterColumn::lights);
  }
  return std::nullopt;
}

HeatMapScale cluster_scale(std::span<const ClusterRow> rows, ClusterColour by) {
  constexpr double most = std::numeric_limits<float>::max();
  constexpr double least = std::numeric_limits<float>::min();
  double lo = most, hi = 0;
  for (const ClusterRow& row : rows) {
    const double value = coloured_value(row, by).value_or(0);
    if (!(value >= least) || value > most) continue;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  if (hi == 0) return {float(1 / decades), 1, true};
  return {float(std::max({lo, hi / decades, least})), float(hi), true};
}

Rgba8 cluster_colour(std::optional<double> value, const HeatMapScale& scale) {
  if (!value) return unknown_colour;
  auto number = float(*value);
  if (std::isfinite(number)) number = darkest + (1 - darkest) * fraction_of(number, scale);
  return {heat_colour(number, {}), 255};
}

Rgba8 line_colour(const ClusterRow& row) {
  if (row.sight == Sight::seen) return proven_seen_colour;
  if (row.sight == Sight::hidden) return proven_hidden_colour;
  if (row.sight == Sight::share) return share_colour;
  return row.visible ? seen_colour : blocked_colour;
}

Overlay overlay_of(const glm::vec3& position, const glm::vec3& normal,
                   std::span<const ClusterRow> rows, const OverlayOptions& options) {
  Overlay out;
  if (options.boxes) add_boxes(rows, options, out);
  if (options.lines)
    for (const ClusterRow& row : rows)
      if (row.node != options.selected) add_representative(position, row, false, out);
  if (normal != glm::vec3(0))
    add_arrow(position, arrow_length * options.scene_diagonal * normal, out);
  out.points.push_back({position, normal_colour, large_dot});
  for (const ClusterRow& row : rows) {
    if (row.node != options.selected) continue;
    if (has_extent(row)) add_box(row.box, selected_colour, thick, out);
    add_representative(position, row, true, out);
  }
  return out;
}

} // namespace lightcuts::viz
