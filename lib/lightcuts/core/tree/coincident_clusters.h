// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <lightcuts/core/tree/dendrogram.h>

namespace lightcuts {

/// Merges lights that share position and axis: those of a group, by index, in two halves, of which
/// the first is the larger one, and each of these likewise. Merging them costs nothing in any
/// order, and in this one the tree is no deeper than it has to be. The other clusters stay as they
/// are; in the order of their ids. clusters: lights of one kind.
[[nodiscard]] std::vector<Cluster> merge_coincident(std::vector<Cluster> clusters,
                                                    Dendrogram& record);

} // namespace lightcuts
