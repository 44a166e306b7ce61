// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/contribution.h>
#include <lightcuts/core/kernels/error_bound.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// Radiance that the cluster sends to the viewer if nothing occludes it, as of one light at the
/// centroid of its intensity, its axis the mean axis: the error of first order cancels. The second
/// moment of the positions corrects the geometric term of omni, oriented and directional lights. A
/// mean of spots says little of any; they shine as their representative does.
/// Exact for a leaf (see transfer()). A mixed cluster: the sum of its children's. For diffuse
/// surfaces and omni lights in error by O((size/distance)^3), else ^2.
template <class Features = AnyFeatures, class OneLobe>
[[nodiscard]] glm::dvec3 cluster_estimate(const LightTree& tree, std::uint32_t node,
                                          const ShadingPoint& point, const OneLobe& lobe) {
  return detail::over_kinds<Features>(tree, node, [&](std::uint32_t i) -> glm::dvec3 {
    const TreeNode& cluster = tree.node(i);
    const Light& one = tree.lights()[cluster.representative];
    if (cluster.is_leaf())
      return transfer<Features>(point, lobe, one, tree.min_distance2()) * cluster.intensity;
    const LightKind kind = Features::known(one.kind);
    const ClusterMoments& moments = tree.moments(i);
    const Sight sight(point, kind, moments.centroid);
    glm::dvec3 e =
        reflected<Features>(point, lobe, sight, kind, tree.min_distance2()) * cluster.intensity;
    if (e == glm::dvec3(0)) return e;
    if constexpr (Features::has_axes) {
      if (kind == LightKind::oriented)
        e *= mean_emission(tree.emission(i), moments.centroid, point.position());
      if (kind == LightKind::spot) e *= emission(one, point.position());
    }
    if (moments.variance == glm::vec3(0)) return e;
    const SecondMoment second(moments, sight.q());
    switch (kind) {
    case LightKind::omni:
      return e * second.factor(point.normal(), 3);
    case LightKind::oriented:
      return e * second.oriented_factor(point.normal(), tree.emission(i).mean_axis);
    case LightKind::directional:
      return e * second.factor(point.normal(), 1);
    case LightKind::spot:
      break;
    }
    return e;
  });
}

} // namespace lightcuts
