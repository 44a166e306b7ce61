// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/shafts/triangle_tree.h>

namespace lightcuts {

/// The convex hull of two boxes, which has all segments from a point of the one to a point of the
/// other (Haines and Wallace 1991, "Shaft Culling for Efficient Ray-Traced Radiosity"): within the
/// box around both, and within planes along an axis that touch one edge of each.
class Shaft {
public:
  /// Neither is empty.
  Shaft(const Box& from, const Box& to);

  /// How far all of it is, at least, from the shaft, metres: the largest distance by which one of
  /// the shaft's planes has it outside. 0 or less: it may touch the shaft. Apart from roundings of
  /// 2^-50 of the coordinates.
  [[nodiscard]] double separation(const Box& box) const;
  [[nodiscard]] double separation(const FlatTriangle& triangle) const;

private:
  /// Unit normal with one component 0, outwards.
  struct Side {
    glm::dvec3 normal;
    double offset;
  };

  Box around_;
  std::array<Side, 12> sides_{};
  int side_count_ = 0;
};

} // namespace lightcuts
