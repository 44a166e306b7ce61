// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/environment/backdrop.h>

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include <lightcuts/render/lighting/circle.h>

namespace lightcuts {
namespace {

/// Whether the angle from a to b, counted one way round, is less than half a turn.
bool is_ahead(const glm::dvec2& a, const glm::dvec2& b) {
  const double turn = a.x * b.y - a.y * b.x;
  return turn > 0 || (turn == 0 && a.x * b.x + a.y * b.y > 0);
}

} // namespace

Backdrop::Backdrop(EnvironmentMap map, double turn) : map_(std::move(map)) {
  for (std::uint32_t y = 0; y < map_.size.y; ++y)
    row_cosines_.push_back(on_unit_circle(y / (2.0 * map_.size.y)).x);
  for (std::uint32_t x = 0; x < map_.size.x; ++x)
    column_ends_.push_back(on_unit_circle(0.5 - (x + 1.0) / map_.size.x + turn / 360));
}

glm::vec3 Backdrop::radiance(const glm::vec3& direction) const {
  const glm::dvec3 d = glm::normalize(glm::dvec3(direction));
  const auto below = std::partition_point(row_cosines_.begin() + 1, row_cosines_.end(),
                                          [&](double cosine) { return cosine >= d.y; });
  const auto row = std::size_t(below - row_cosines_.begin()) - 1;
  // Columns go down in longitude. The first half of them ends within half a turn of the left edge.
  const glm::dvec2 along(d.z, d.x), left = column_ends_.back();
  const auto middle = column_ends_.begin() + std::ptrdiff_t(column_ends_.size() / 2);
  const bool in_first_half = column_ends_.size() < 2 || is_ahead(along, left);
  const auto begin = in_first_half ? column_ends_.begin() : middle;
  const auto end = in_first_half ? middle : column_ends_.end() - 1;
  const auto column = std::partition_point(
      begin, end, [&](const glm::dvec2& edge) { return is_ahead(along, edge); });
  return map_.radiance[row * map_.size.x + std::size_t(column - column_ends_.begin())];
}

} // namespace lightcuts
