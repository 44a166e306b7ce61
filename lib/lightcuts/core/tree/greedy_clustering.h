// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <lightcuts/core/tree/dendrogram.h>

namespace lightcuts {

/// Merges the clusters, at least one, to one as greedy clustering does: the cheapest pair of all
/// each time, that with the lowest ids among equals.
Cluster cluster_greedily(std::vector<Cluster> clusters, Dendrogram& record);

} // namespace lightcuts
