// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/cut_selector.h>

namespace lightcuts {

/// Lightcuts as Walter et al. (2005) have it, to compare with: the bound is the product of separate
/// maxima of cosine and 1/distance^2 (each exact over the box), the estimate is the
/// representative's contribution scaled by intensity.
struct PaperRules : LightcutsRules {
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
    return product_bound(tree.node(node), point);
  }
  static glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             const glm::vec3& /*bound*/) {
    const TreeNode& cluster = tree.node(node);
    return transfer(point, tree.lights()[cluster.representative].position) * cluster.intensity;
  }
};

using PaperCutSelector = BasicCutSelector<PaperRules>;

} // namespace lightcuts
