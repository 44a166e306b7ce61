// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// Radiance that a cluster of one kind sends to the viewer if nothing occludes it, as of one light
/// at the centroid of its intensity, its axis the mean axis: the error of first order cancels. The
/// second moment of the positions corrects the geometric term of omni, oriented and directional
/// lights. Exact for a leaf (see transfer()). For diffuse surfaces and omni lights in error by
/// O((size/distance)^3), else ^2.
template <class Kind, class OneLobe>
[[nodiscard]] glm::dvec3 centroid_estimate(const LightTree& tree, std::uint32_t node,
                                           const ShadingPoint& point, const OneLobe& lobe) {
  constexpr bool has_axes = has_axis(Kind::kind);
  const TreeNode& cluster = tree.node(node);
  const Light& one = tree.lights()[cluster.representative];
  if (cluster.is_leaf())
    return transfer<Kind>(point, lobe, one, tree.min_distance2()) * cluster.intensity;
  const ClusterMoments& moments = tree.moments(node);
  const Sight sight(point, Kind::kind, moments.centroid);
  glm::dvec3 e =
      reflected(point, lobe, sight, Kind::kind, tree.min_distance2()) * cluster.intensity;
  if (e == glm::dvec3(0)) return e;
  const ClusterEmission* emission = has_axes ? &tree.emission(node) : nullptr;
  if constexpr (has_axes)
    e *= Kind::mean_emission(*emission, one, moments.centroid, point.position());
  if (moments.variance == glm::vec3(0)) return e;
  return e * Kind::second_moment_factor(SecondMoment(moments, sight.q()), point.normal(), emission);
}

} // namespace lightcuts
