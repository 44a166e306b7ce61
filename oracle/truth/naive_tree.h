// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/tree/light_tree.h>
#include <oracle/subjects/topology.h>

namespace lightcuts::oracle {

/// What greedy clustering knows of a cluster.
struct NaiveCluster {
  Box box, axes; ///< of positions, and of axes scaled as build() has it
  glm::dvec3 intensity;
  double weight = 0;       ///< of all channels
  std::uint32_t first = 0; ///< lowest light index
  std::uint32_t representative = 0;
  double representative_weight = 0; ///< of that light, all channels
  std::uint32_t light_count = 1;
  std::int32_t children[2] = {-1, -1}; ///< indices into the same list; -1: a leaf
};

/// What merging two clusters costs.
using Metric = std::function<double(const NaiveCluster&, const NaiveCluster&)>;

/// (sum of intensities) (diagonal^2 + spread of axes); see build().
[[nodiscard]] double greedy_metric(const NaiveCluster& a, const NaiveCluster& b);

/// The definition of the greedy tree, followed to the letter in O(N^3): merges lights of one place
/// and axis first, the first half of them with the second, then the cheapest of all pairs each
/// time, that with the lowest light indices among equals. Lights of one kind; the last cluster is
/// the root. A representative is that of the first child.
[[nodiscard]] std::vector<NaiveCluster> naive_clusters(const LightSet& lights,
                                                       const Metric& metric = greedy_metric);

/// naive_clusters() as a tree of the library.
[[nodiscard]] LightTree naive_tree(const LightSet& lights, const Metric& metric = greedy_metric);

/// Sum of greedy_metric() over all clusters of more than one light. Lights of one kind.
[[nodiscard]] double tree_cost(const Topology& topology, const LightSet& lights);
[[nodiscard]] double naive_tree_cost(const LightSet& lights);

} // namespace lightcuts::oracle
