// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts::oracle {

/// The suprema that the library's bound of a cluster of one kind is a product of.
struct Suprema {
  double min_distance;       ///< metres; of directional lights, 1
  double max_cosine_falloff; ///< of n.l falloff in one
  double max_falloff;
  double max_emission;
  glm::dvec3 shine; ///< of lobe n.l falloff
};

[[nodiscard]] Suprema suprema_at(const LightTree& tree, std::uint32_t node,
                                 const ShadingPoint& point);
/// Over all points of the block, too.
[[nodiscard]] Suprema suprema_over(const LightTree& tree, std::uint32_t node,
                                   const ShadingBlock& block);

} // namespace lightcuts::oracle
