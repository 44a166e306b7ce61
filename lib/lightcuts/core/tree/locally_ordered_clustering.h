// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <lightcuts/core/tree/dendrogram.h>

namespace lightcuts {

/// How many places each cluster looks to either side for a partner.
inline constexpr std::uint32_t search_radius = 4;

/// Merges the clusters, at least one, to one by parallel locally-ordered clustering (Meister and
/// Bittner 2018): along a Morton curve, each looks for its cheapest partner among those at most
/// search_radius places away; those that choose each other merge, in rounds. Among partners of
/// equal cost each takes that with the least exclusive or of their places on the curve: among many
/// equals, this pairs neighbours.
Cluster cluster_in_local_order(std::vector<Cluster> clusters, Dendrogram& record);

} // namespace lightcuts
