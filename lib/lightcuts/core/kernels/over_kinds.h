// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What one_kind(i) makes of a cluster i whose lights are of one kind; of a mixed one, the sum over
/// its children.
template <class OneKind>
glm::dvec3 over_kinds(const LightTree& tree, std::uint32_t i, const OneKind& one_kind) {
  const TreeNode& node = tree.node(i);
  if (!node.is_mixed()) [[likely]]
    return one_kind(i);
  return over_kinds(tree, node.first_child, one_kind) +
         over_kinds(tree, node.first_child + 1, one_kind);
}

/// Upper bounds of the clusters of one kind, added and rounded up.
template <class OneKind>
glm::vec3 bound_over_kinds(const LightTree& tree, std::uint32_t node, const OneKind& one_kind) {
  if (!tree.node(node).is_mixed()) [[likely]]
    return one_kind(node);
  const glm::dvec3 sum =
      over_kinds(tree, node, [&](std::uint32_t i) { return glm::dvec3(one_kind(i)); });
  return {round_up(sum.x), round_up(sum.y), round_up(sum.z)};
}

} // namespace lightcuts
