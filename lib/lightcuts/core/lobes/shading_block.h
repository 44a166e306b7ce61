// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/shading/block_sight.h>

namespace lightcuts {

/// Neighbouring shading points that are bounded together: what holds for the block holds for each
/// of them (Walter et al. 2006, "Multidimensional Lightcuts", pair clusters of both ends).
class ShadingBlock {
public:
  /// Throws InputError where there is no point, or where lobes differ in more than reflectance.
  explicit ShadingBlock(std::span<const ShadingPoint> points);

  [[nodiscard]] const Box& positions() const { return positions_; }
  [[nodiscard]] const BlockDirections& directions() const { return directions_; }
  /// The largest reflectances among the points.
  [[nodiscard]] const Material& material() const { return material_; }
  /// The smallest diffuse reflectance among the points.
  [[nodiscard]] const glm::vec3& least_diffuse() const { return least_diffuse_; }

private:
  void add(const ShadingPoint& point);

  Box positions_ = Box::empty();
  BlockDirections directions_;
  Material material_;
  glm::vec3 least_diffuse_;
};

} // namespace lightcuts
