// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/shafts/triangle_tree.h>

namespace lightcuts {

/// Where the shadow rays of a block start, and the box that has the lights to which they go.
struct RayEnds {
  std::vector<glm::dvec3> origins;     ///< one at least
  Box from = Box::empty();             ///< around these, floats as they are
  std::array<glm::dvec3, 8> corners{}; ///< of a box around these that is turned as they lie
  Box to = Box::empty();               ///< of the lights
  double longest = 0;                  ///< no ray is longer, metres

  void start_at(std::span<const glm::vec3> points);
  void end_in(const Box& lights);
};

/// A length that no ray of these ends is longer than, nor the way from where one starts to any
/// point of the box.
[[nodiscard]] double reach(const RayEnds& ends, const Box& box);

/// How far off the shaft, as a share of reach(), a box must be to be left out of it: its
/// triangles are missed unless they may be met edge-on.
inline constexpr double shaft_margin = 0x1p-8;

/// Whether a ray from this box, no longer than `longest`, may be so close to a triangle's plane all
/// along that an occluder may take it for blocked by the triangle though it is shaft_margin off.
[[nodiscard]] bool may_be_met_edge_on(const FlatTriangle& triangle, const Box& from,
                                      double longest);

/// Whether Occluder::occluded() finds, for certain, that none of the rays between these ends meets
/// the triangle, which is so far off their shaft.
[[nodiscard]] bool certainly_missed(const FlatTriangle& triangle, const RayEnds& ends,
                                    double separation);

/// Whether Occluder::occluded() finds, for certain, that each ray between these ends is blocked by
/// the triangle, or by it or its partner (the same: it has none).
[[nodiscard]] bool certainly_covers(const FlatTriangle& triangle, const FlatTriangle& partner,
                                    const RayEnds& ends);

} // namespace lightcuts
