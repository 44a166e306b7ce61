// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/cut/cut_selector.h>

namespace lightcuts {

/// Lightcuts as Walter et al. (2005) have it, to compare with: the bound is the product of separate
/// maxima of cosine and falloff (each exact over the box), the estimate is the representative's
/// contribution scaled by intensity.
template <class TheFeatures>
struct BasicPaperRules : BasicLightcutsRules<TheFeatures> {
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    return product_bound<TheFeatures>(tree, node, point, lobe);
  }
  template <class OneLobe>
  static glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             const OneLobe& lobe, const glm::vec3& bound) {
    const TreeNode& cluster = tree.node(node);
    const glm::dvec3 e = transfer<TheFeatures>(point, lobe, tree.lights()[cluster.representative],
                                               tree.min_distance2()) *
                         cluster.intensity;
    // Of a mixed cluster the representative says little; nor is it below the bound.
    return cluster.is_mixed() ? glm::min(e, glm::dvec3(bound)) : e;
  }
};

using PaperRules = BasicPaperRules<AnyFeatures>;
using PaperCutSelector = BasicCutSelector<PaperRules>;

} // namespace lightcuts
