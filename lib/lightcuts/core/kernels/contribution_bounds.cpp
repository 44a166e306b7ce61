// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bounds.h>

#include <cassert>
#include <variant>

#include <lightcuts/core/kernels/error_bound.h>

namespace lightcuts {
namespace {

/// JointSuprema of omni lights, in one piece where no distance is clamped.
template <bool Clamps>
struct InlinedSuprema : JointSuprema<Features<only(LightKind::omni), Clamps, true>> {
  static double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double min_distance2) {
    using Base = JointSuprema<Features<only(LightKind::omni), Clamps, true>>;
    if constexpr (Clamps)
      if (lightcuts::min_distance2(from, box) < min_distance2) [[unlikely]]
        return Base::max_cosine_falloff(kind, n, from, box, min_distance2);
    return detail::joint_sup(n, from, box);
  }
};

/// All calls inlined, so that what belongs to the point is computed once.
template <bool Clamps>
[[gnu::flatten]] void bound_all_diffuse(const LightTree& tree, const ShadingPoint& point,
                                        std::span<glm::vec3> bounds) {
  const ShadingPoint own = point; // which no writing to bounds can change
  for (std::uint32_t i = 0; i < bounds.size(); ++i)
    bounds[i] = bound_by(InlinedSuprema<Clamps>(), tree, i, own, NoLobe());
}

template <class OneLobe>
void bound_all(const LightTree& tree, const ShadingPoint& point, const OneLobe& lobe,
               std::span<glm::vec3> bounds) {
  for (std::uint32_t i = 0; i < bounds.size(); ++i)
    bounds[i] = contribution_bound(tree, i, point, lobe);
}

} // namespace

void contribution_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds) {
  assert(bounds.size() == tree.nodes().size());
  if (point.material().is_glossy() || tree.lights().kinds() != only(LightKind::omni))
    std::visit([&](const auto& lobe) { bound_all(tree, point, lobe, bounds); },
               point.material().lobe);
  else if (tree.min_distance2() > 0)
    bound_all_diffuse<true>(tree, point, bounds);
  else
    bound_all_diffuse<false>(tree, point, bounds);
}

} // namespace lightcuts
