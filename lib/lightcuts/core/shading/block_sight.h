// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/geometry/difference_box.h>
#include <lightcuts/core/geometry/orientation_cone.h>
#include <lightcuts/core/numerics/angle.h>
#include <lightcuts/core/shading/shading_frame.h>

namespace lightcuts {

/// Directions of the points of a block.
struct BlockDirections {
  OrientationCone normals, viewers, mirrors; ///< each has those of all points, in real numbers
  double least_viewer_cosine = 0;            ///< of n.v, among points that are seen from in front
  double most_viewer_cosine = 0;             ///< not above 0: all are seen from behind
};

/// All lights of a box seen from all points of a block: what lobes are bounded with, in the way of
/// BoxSight.
struct BlockSight {
  const BlockDirections& block;
  const DifferenceBox& q;
  double max_cosine_falloff; ///< sup of n.l falloff; +inf allowed, > 0
  double max_falloff;        ///< sup of the falloff alone; +inf allowed

  [[nodiscard]] double least_viewer_cosine() const { return block.least_viewer_cosine; }

  /// Upper bound of cos(r,l).
  [[nodiscard]] double max_mirror_cosine() const { return max_cosine_with(block.mirrors); }

  /// Lower bound of tan^2(n,h); see BoxSight.
  [[nodiscard]] double min_half_tangent2() const {
    constexpr Angle uncertainty{1, ShadingFrame::mirror_error};
    const Angle least = difference(half(least_angle_with(block.mirrors)), uncertainty);
    const double tangent = std::max(0.0, least.sin - slack) / (least.cos + slack);
    return tangent * tangent;
  }
  [[nodiscard]] double min_half_tangent2(double light_cosine, double between_cosine) const {
    const double up = light_cosine + block.most_viewer_cosine, sum2 = 2 + 2 * between_cosine;
    const double tangent2 = (sum2 - 0x1p-44) * (1 - 0x1p-30) / (up * up) - 1;
    const bool counts = sum2 > 0x1p-12 && tangent2 > 0x1p-10;
    return std::max(min_half_tangent2(), counts ? tangent2 : 0);
  }

  /// Bounds of n.l, in [0, 1].
  [[nodiscard]] double min_cosine_quickly() const {
    return std::max(0.0, min_cosine_with(block.normals));
  }
  [[nodiscard]] double max_cosine_quickly() const { return max_cosine_with(block.normals); }
  /// Lower bound of l.v, in [-1, 1].
  [[nodiscard]] double min_between_cosine_quickly() const {
    return std::max(-1.0, min_cosine_with(block.viewers));
  }

  // More than the angles here err by.
  static constexpr double slack = 16 * angle_error;

private:
  [[nodiscard]] Angle least_angle_with(const OrientationCone& cone) const {
    return difference(min_angle(cone.axis, q), cone.half_angle());
  }
  /// 0 where the cosine is below 0.
  [[nodiscard]] double max_cosine_with(const OrientationCone& cone) const {
    const double cosine = least_angle_with(cone).cos + slack;
    return std::clamp(cosine, 0.0, 1.0);
  }
  [[nodiscard]] double min_cosine_with(const OrientationCone& cone) const {
    return sum(supplement(min_angle(-cone.axis, q)), cone.half_angle()).cos - slack;
  }
};

} // namespace lightcuts
