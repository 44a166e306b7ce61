// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/cluster_bound.h>
#include <lightcuts/core/kernels/suprema.h>
#include <lightcuts/core/lobes/shading_block.h>

namespace lightcuts {
namespace detail {

/// Upper bound of n.l falloff over q and all unit normals of a cone with axis a and half-angle g,
/// falloff at most `falloff`. From a to n the cosine with l turns into at most
///   cos(max(0, (a,l) - g)) <= cos g max(0, a.l) + sin g   (g at most 90 degrees) ;
/// both are used, the former with the nearest q. Of one normal: the joint supremum.
template <class Kind>
double max_cosine_falloff(const OrientationCone& normals, const DifferenceBox& q,
                          double min_distance2, double falloff) {
  const double joint = JointSuprema<Kind>::max_cosine_falloff(normals.axis, q, min_distance2) /
                       glm::length(glm::dvec3(normals.axis));
  if (normals.chord2 == 0) return joint;
  constexpr double least_cosine = 0x1p-20;
  const Angle g = normals.half_angle();
  const double cosine = difference(min_angle(normals.axis, q), g).cos;
  if (cosine < -0x1p-40) return 0;
  const double apart = std::clamp(cosine + BlockSight::slack, least_cosine, 1.0) * falloff;
  const double turned = g.cos > 0 ? g.cos * joint + g.sin * falloff : falloff;
  return std::min(apart, turned);
}

/// Lower bound of n.l falloff over the same: from a to n the cosine with l turns into no less than
///   cos g a.l - sin g   and   cos((a,l) + g) .
template <class Kind>
double min_cosine_falloff(const OrientationCone& normals, const DifferenceBox& q,
                          double min_distance2, double most_falloff) {
  const auto falloff_at = [&](double length2) {
    return falloff(Kind::kind, length2, min_distance2);
  };
  const double joint =
      min_cosine_times(normals.axis, q, falloff_at) / glm::length(glm::dvec3(normals.axis));
  if (normals.chord2 == 0) return joint;
  constexpr double slack = 16 * angle_error;
  const Angle g = normals.half_angle();
  const double turned = g.cos > 0 ? (g.cos - slack) * joint - (g.sin + slack) * most_falloff : 0;
  const double cosine = sum(supplement(min_angle(-normals.axis, q)), g).cos - slack;
  const double apart = cosine > 0 ? cosine * falloff_at(max_length2(q) * (1 + 0x1p-40)) : 0;
  return std::max({0.0, turned, apart});
}

} // namespace detail

/// Upper bound, per channel, of what the cluster, whose lights are of one kind, contributes to the
/// radiance seen at any point of the block: cluster_bound() with q ranging over the differences of
/// two boxes, the normals over a cone, and the largest reflectances.
template <class Kind, class OneLobe>
[[nodiscard]] glm::vec3 block_bound(const LightTree& tree, std::uint32_t i,
                                    const ShadingBlock& block, const OneLobe& lobe) {
  constexpr bool is_diffuse = std::is_same_v<OneLobe, NoLobe>;
  const TreeNode& cluster = tree.node(i);
  const Box origin{glm::vec3(0), glm::vec3(0)};
  const DifferenceBox q =
      DifferenceBox::between(is_at_infinity(Kind::kind) ? origin : block.positions(), cluster.box);
  const double falloff = JointSuprema<Kind>::max_falloff(q, tree.min_distance2());
  const double joint = detail::max_cosine_falloff<Kind>(block.directions().normals, q,
                                                        tree.min_distance2(), falloff);
  if (joint == 0) return glm::vec3(0);
  double emitted = 1;
  if constexpr (has_axis(Kind::kind)) {
    emitted = Kind::max_emission(tree.emission(i), q);
    if (emitted == 0) return glm::vec3(0);
  }
  const double geometric = joint * detail::bound_inflation;
  glm::dvec3 shine(0);
  if constexpr (!is_diffuse)
    shine =
        lobe.bound(BlockSight{block.directions(), q, geometric, falloff * detail::bound_inflation});
  return detail::bound_of_product(cluster.intensity, emitted, block.material().diffuse, geometric,
                                  shine);
}

/// Lower bound of what the cluster of one kind contributes to any point of the block where nothing
/// occludes: cluster_lower_bound() over the same; not rounded to float yet.
template <class Kind>
[[nodiscard]] glm::dvec3 block_lower_bound(const LightTree& tree, std::uint32_t i,
                                           const ShadingBlock& block) {
  constexpr double deflate = 1 - 0x1p-26; // see bound_inflation
  const TreeNode& cluster = tree.node(i);
  const Box origin{glm::vec3(0), glm::vec3(0)};
  const DifferenceBox q =
      DifferenceBox::between(is_at_infinity(Kind::kind) ? origin : block.positions(), cluster.box);
  if (min_length2(q) == 0) return glm::dvec3(0); // what is at a point sends it nothing
  const double most_falloff = JointSuprema<Kind>::max_falloff(q, tree.min_distance2());
  double geometric = detail::min_cosine_falloff<Kind>(block.directions().normals, q,
                                                      tree.min_distance2(), most_falloff) *
                     deflate;
  if constexpr (has_axis(Kind::kind))
    if (geometric > 0) geometric *= Kind::min_emission(tree.emission(i), q) * deflate;
  return geometric == 0 ? glm::dvec3(0)
                        : glm::dvec3(block.least_diffuse()) * std::numbers::inv_pi *
                              cluster.intensity * geometric;
}

} // namespace lightcuts
