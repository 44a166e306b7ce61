// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/methods/paper_rules.h>

namespace lightcuts {

/// The paper's rules, but for the estimate: the representative as it is, not scaled to the
/// cluster's intensity. To compare with: its error is one-sided and steady, but every cluster that
/// is not a leaf loses its other lights, so that pictures are too dark, or cuts near leaves. The
/// certified error holds, since the representative alone is no brighter than the cluster.
template <class TheFeatures>
struct BasicUnscaledRules : BasicPaperRules<TheFeatures> {
  template <class OneLobe>
  static glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             const OneLobe& lobe, const glm::vec3& /*bound*/) {
    const Light& light = tree.lights()[tree.node(node).representative];
    return transfer<TheFeatures>(point, lobe, light, tree.min_distance2()) *
           glm::dvec3(light.intensity);
  }
};

using UnscaledRules = BasicUnscaledRules<AnyFeatures>;
using UnscaledCutSelector = BasicCutSelector<UnscaledRules>;

} // namespace lightcuts
