// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/cluster_bound.h>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// Upper bound, per channel, of the cluster's contribution to the radiance seen at the point: see
/// cluster_bound(); a mixed cluster: the sum of its children's. BoundRule::joint has the maximum of
/// n.l/|q|^2 over the cluster's box in one and exact, those of the lobe and of emission as stated
/// there. Since 0 <= truth <= bound, it bounds the error of any estimate between 0 and it, too
/// (Walter et al. 2005, section 4.1). Never below the supremum in real numbers. Never NaN; +inf
/// only where the supremum is, or where it exceeds the largest float.
[[nodiscard]] glm::vec3 contribution_bound(const LightTree& tree, std::uint32_t node,
                                           const ShadingPoint& point,
                                           BoundRule rule = BoundRule::joint);

/// contribution_bound() of every node of the tree at one point, the same bits: for statistics and
/// checks, several times as fast. bounds: one per node.
void contribution_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds);

/// contribution_bound() for a block of shading points: at least that of each of them. As tight as
/// the joint one where the block is a point, looser with its extent and its cone of normals.
[[nodiscard]] glm::vec3 contribution_bound(const LightTree& tree, std::uint32_t node,
                                           const ShadingBlock& block);

/// contribution_bound() without the distance: intensity material n.l emission over the box. Of a
/// cluster that is not mixed.
[[nodiscard]] glm::vec3 cosine_bound(const LightTree& tree, std::uint32_t node,
                                     const ShadingPoint& point);

/// Lower bound of the cluster's contribution where nothing occludes: intensity min(emission)
/// diffuse/pi min(n.l falloff) over the cluster's box, the lobe left out. Rounded down: never above
/// the infimum in real numbers.
[[nodiscard]] glm::vec3 contribution_lower_bound(const LightTree& tree, std::uint32_t node,
                                                 const ShadingPoint& point);
/// A lower bound of what it contributes to any point of the block.
[[nodiscard]] glm::vec3 contribution_lower_bound(const LightTree& tree, std::uint32_t node,
                                                 const ShadingBlock& block);

/// What the cluster is taken to contribute if its representative is seen, given its bound: see
/// ClusterKernel::estimate(). A mixed cluster: the sum of its children's, at most the bound.
[[nodiscard]] glm::dvec3 cluster_estimate(const LightTree& tree, std::uint32_t node,
                                          const ShadingPoint& point, const glm::vec3& bound,
                                          EstimateRule rule = EstimateRule::centroid);

/// cluster_estimate() by centroids at many points, whose lobes are of one type, apart from the
/// bound, which a caller is to cut them to; several times as fast. results: one per point.
void centroid_estimates(const LightTree& tree, std::uint32_t node,
                        std::span<const ShadingPoint* const> points, std::span<glm::dvec3> results);

} // namespace lightcuts
