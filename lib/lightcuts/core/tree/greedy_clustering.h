// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <lightcuts/core/tree/dendrogram.h>

namespace lightcuts {

/// Merges the lights of one kind, at least one, to one cluster as greedy clustering does: the
/// cheapest pair of all each time, that with the lowest ids among equals; but lights that coincide
/// first, as merge_coincident() has it.
Cluster cluster_greedily(std::vector<Cluster> clusters, Dendrogram& record);

} // namespace lightcuts
