// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// contribution_bound() of every node of the tree at one point, the same bits: for statistics and
/// checks, several times as fast for omni lights on diffuse surfaces. bounds: one per node.
void contribution_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds);

} // namespace lightcuts
