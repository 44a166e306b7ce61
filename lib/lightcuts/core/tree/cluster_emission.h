// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/orientation_cone.h>
#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {

struct TreeNode;

/// Where the oriented lights or spots of a cluster shine.
struct ClusterEmission {
  OrientationCone cone;      ///< has all their axes, in real numbers
  glm::vec3 mean_axis{0};    ///< mean of the unit axes, weighted by intensity; not unit
  glm::vec3 axis_square{0};  ///< mean of the products of their components: xx, yy, zz
  glm::vec3 axis_product{0}; ///< yz, zx, xy
  float cos_inner = 1;       ///< of spots: the least of each
  float cos_outer = 1;
};

/// For all nodes, in one bottom-up pass; nodes as LightTree has them.
[[nodiscard]] std::vector<ClusterEmission> emission_of(std::span<const TreeNode> nodes,
                                                       const LightSet& lights);

} // namespace lightcuts
