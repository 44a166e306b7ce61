// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/lobes/shading_point.h>

namespace lightcuts {

/// A shading point among its neighbours, and where in the picture it is, pixels.
struct BlockPoint {
  ShadingPoint point;
  glm::vec2 place;
};

/// Indices of points, ascending.
using Members = std::vector<std::uint32_t>;

/// The points in groups of those that a ShadingBlock may have together: lobes alike but for their
/// reflectance.
[[nodiscard]] std::vector<Members> groups_of_like_lobes(std::span<const BlockPoint> points);

/// Two parts of some points, two at least, neither of them empty: apart by their normals where
/// those differ by more than about 11 degrees, else by where they lie; at the middle between the
/// outermost ones, so that what lies far apart is parted first.
[[nodiscard]] std::pair<Members, Members> parted(std::span<const BlockPoint> points,
                                                 Members members);

} // namespace lightcuts
