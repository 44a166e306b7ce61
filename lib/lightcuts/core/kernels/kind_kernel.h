// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What is compiled for each kind of light, in a translation unit of its own, lobes inside. Nodes
/// are of that kind.
struct KindKernel {
  using Bound = glm::vec3(const LightTree&, std::uint32_t node, const ShadingPoint&);
  using Estimate = glm::dvec3(const LightTree&, std::uint32_t node, const ShadingPoint&);

  Bound* bound[bound_rule_count];
  Estimate* centroid_estimate;
  /// Upper bound of intensity material n.l emission alone, whatever the distance.
  Bound* cosine_bound;
  Estimate* lower_bound; ///< not rounded down to float yet
  glm::vec3 (*block_bound)(const LightTree&, std::uint32_t node, const ShadingBlock&);
  /// Not rounded down to float yet.
  glm::dvec3 (*block_lower_bound)(const LightTree&, std::uint32_t node, const ShadingBlock&);
  /// centroid_estimate() of one node at many points.
  void (*centroid_estimates)(const LightTree&, std::uint32_t node,
                             std::span<const ShadingPoint* const>, glm::dvec3* results);
  /// ClusterKernel::evaluate() by the default rules.
  void (*evaluate)(const LightTree&, const ShadingPoint&, std::span<CutCluster>);
  /// Joint bounds of nodes 0, 1, ...
  void (*all_bounds)(const LightTree&, const ShadingPoint&, std::span<glm::vec3>);
  /// transfer() of each light.
  void (*transfers)(const ShadingPoint&, std::span<const Light>, double min_distance2,
                    glm::dvec3* results);
};

/// The kernel of one kind of LightKindList, defined in a translation unit that CMake makes for it.
template <class Kind>
struct CompiledForKind {
  static const KindKernel& kernel();
};

[[nodiscard]] const KindKernel& kernel_of(LightKind kind);

} // namespace lightcuts
