// SPDX-License-Identifier: MIT
#include <lightcuts/contribution_bounds.h>

#include <cassert>
#include <variant>

#include <lightcuts/error_bound.h>

namespace lightcuts {
namespace {

template <class Features, class OneLobe>
void bound_all(const LightTree& tree, const ShadingPoint& point, const OneLobe& lobe,
               std::span<glm::vec3> bounds) {
  const ShadingPoint own = point; // that no writing to bounds can change
  for (std::uint32_t i = 0; i < bounds.size(); ++i)
    bounds[i] = contribution_bound<Features>(tree, i, own, lobe);
}

/// All calls in one piece, so that what belongs to the point is computed once.
template <bool Clamps>
[[gnu::flatten]] void bound_all_diffuse(const LightTree& tree, const ShadingPoint& point,
                                        std::span<glm::vec3> bounds) {
  bound_all<Features<only(LightKind::omni), Clamps, true>>(tree, point, NoLobe(), bounds);
}

} // namespace

void contribution_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds) {
  assert(bounds.size() == tree.nodes().size());
  if (point.material().is_glossy() || tree.lights().kinds() != only(LightKind::omni))
    std::visit([&](const auto& lobe) { bound_all<AnyFeatures>(tree, point, lobe, bounds); },
               point.material().lobe);
  else if (tree.min_distance2() > 0)
    bound_all_diffuse<true>(tree, point, bounds);
  else
    bound_all_diffuse<false>(tree, point, bounds);
}

} // namespace lightcuts
