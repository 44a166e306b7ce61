// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/greedy_clustering.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include <lightcuts/core/tree/cluster_index.h>
#include <lightcuts/core/tree/coincident_clusters.h>

namespace lightcuts {
namespace {

/// Follows nearest-neighbour chains until half of the index's clusters have gone: from any cluster
/// to cheapest partners, until two are each other's, which merge. Costs never fall when clusters
/// merge, and pairs are ordered strictly (cost, then ids), so this makes the same merges as taking
/// the cheapest pair of all each time, in another order (Murtagh 1983; Walter et al. 2008, section
/// 3.2).
void merge_half(ClusterIndex& index, Dendrogram& record) {
  const std::size_t clusters = index.clusters().size();
  std::size_t merges = clusters - std::max<std::size_t>(clusters / 2, 1);
  std::vector<std::uint32_t> chain;
  for (std::uint32_t start = 0; merges > 0;) {
    if (chain.empty()) {
      while (!index.holds_cluster(start)) start = (start + 1) % index.slot_count();
      chain.push_back(start);
    }
    const std::uint32_t last = chain.back();
    const std::uint32_t partner = index.nearest(last).slot;
    if (chain.size() < 2 || partner != chain[chain.size() - 2]) {
      chain.push_back(partner);
      continue;
    }
    index.replace(last, partner, record.join(index.at(last), index.at(partner)));
    chain.resize(chain.size() - 2);
    --merges;
  }
}

} // namespace

Cluster cluster_greedily(std::vector<Cluster> clusters, Dendrogram& record) {
  clusters = merge_coincident(std::move(clusters), record);
  while (clusters.size() > 1) {
    record.leave_if_cancelled(); // an index of millions takes a second
    ClusterIndex index(std::move(clusters));
    merge_half(index, record);
    clusters = index.clusters();
  }
  return clusters.front();
}

} // namespace lightcuts
