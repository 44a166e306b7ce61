// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/tree/light_tree.h>
#include <oracle/properties/both_sides.h>

/// What explain_cluster() and explain_block() show of a cluster alike.
namespace lightcuts::oracle {

/// Which cluster, of how many lights.
[[nodiscard]] std::string cluster_head(const PointCase& at, std::uint32_t node);

/// Each light of the cluster, and what it contributes, factor by factor.
[[nodiscard]] std::string lights_text(const PointCase& at, std::uint32_t node);

/// A cluster of the library's: the subject's own where it has the library's tree, else one made of
/// the same lights.
struct LibraryCluster {
  std::optional<LightTree> made;
  const LightTree* tree;
  std::uint32_t node;

  LibraryCluster(const Judged& judged, const PointCase& at, std::uint32_t of);
  LibraryCluster(const LibraryCluster&) = delete;
  LibraryCluster& operator=(const LibraryCluster&) = delete;

  [[nodiscard]] glm::vec3 bound(const ShadingPoint& point) const;
  [[nodiscard]] glm::vec3 bound(const ShadingBlock& block) const;
};

/// Nine digits, or what it is more or less than 1 where those do not show it.
[[nodiscard]] std::string ratio_text(const Exact& ratio);

/// The row of the truth over the bound, per channel.
[[nodiscard]] std::string truth_over(const PointCase& at, std::uint32_t node,
                                     const glm::vec3& bound);

/// The first channel where the right side is too small, and by how much. of_bound: the right side
/// is a bound of the cluster, so that what it leaves for some of its factors can be shown.
[[nodiscard]] std::string parting(const LibraryCluster& cluster, const BothSides& sides,
                                  bool of_bound, const PointCase& at, std::uint32_t node);

} // namespace lightcuts::oracle
