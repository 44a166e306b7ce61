// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>

#include <lightcuts/core/cut/cut_selector.h>

namespace lightcuts {

/// A lobe bounded as if some light stood in its brightest direction: no cosine of it is looked at.
template <class OneLobe>
struct LobeAtItsPeak {
  const OneLobe& lobe;

  [[nodiscard]] glm::dvec3 bound(const BoxSight& sight) const {
    constexpr float most = std::numeric_limits<float>::max();
    const Box everywhere{glm::vec3(-most), glm::vec3(most)};
    return lobe.bound(
        {sight.frame, sight.from, everywhere, sight.max_cosine_falloff, sight.max_falloff});
  }
};

/// Lightcuts without the specular bound, to compare with: the lobe's cosine is taken to be 1 for
/// every cluster. Right, and loose wherever a glossy surface looks elsewhere than at the lights.
/// On diffuse surfaces the same as BasicLightcutsRules.
template <class TheFeatures>
struct BasicNoSpecularBoundRules : BasicLightcutsRules<TheFeatures> {
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    if constexpr (std::is_same_v<OneLobe, NoLobe>)
      return contribution_bound<TheFeatures>(tree, node, point, lobe);
    else
      return bound_by(JointSuprema<TheFeatures>(), tree, node, point, LobeAtItsPeak<OneLobe>{lobe});
  }
};

using NoSpecularBoundRules = BasicNoSpecularBoundRules<AnyFeatures>;
using NoSpecularBoundCutSelector = BasicCutSelector<NoSpecularBoundRules>;

} // namespace lightcuts
