// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/orientation_cone.h>
#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {

struct TreeNode;

/// What the lights with profiles of a cluster share.
struct ClusterProfile {
  Profile profile;    ///< of all lights, where they are in one frame
  Profile envelope;   ///< alike in all half-planes, and at least what each light's share is there
  glm::vec3 plane{0}; ///< Light::plane of all, where they are in one frame
  bool one_frame = true; ///< axis, plane and profile are the same for all lights
};

/// Where the oriented lights, spots or luminaires of a cluster shine.
struct ClusterEmission {
  OrientationCone cone;      ///< has all their axes, in real numbers
  glm::vec3 mean_axis{0};    ///< mean of the unit axes, weighted by intensity; not unit
  glm::vec3 axis_square{0};  ///< mean of the products of their components: xx, yy, zz
  glm::vec3 axis_product{0}; ///< yz, zx, xy
  float cos_inner = 1;       ///< of spots: the least of each
  float cos_outer = 1;
  std::shared_ptr<const ClusterProfile> profile; ///< of lights with profiles, else none
};

/// For all nodes, in one bottom-up pass; nodes as LightTree has them.
[[nodiscard]] std::vector<ClusterEmission> emission_of(std::span<const TreeNode> nodes,
                                                       const LightSet& lights);

} // namespace lightcuts
