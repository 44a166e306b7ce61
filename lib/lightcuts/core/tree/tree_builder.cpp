// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/tree_builder.h>

#include <algorithm>
#include <vector>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/tree/dendrogram.h>
#include <lightcuts/core/tree/greedy_clustering.h>
#include <lightcuts/core/tree/locally_ordered_clustering.h>

namespace lightcuts {

LightTree build(const LightSet& lights, const BuildConfig& config) {
  if (lights.empty()) return {};
  if (lights.size() > (std::size_t(1) << 31))
    throw InputError(InputFault::too_large,
                     "more than 2^31 lights: a tree node's index has 32 bits");
  Dendrogram record(lights, config);
  record.leave_if_cancelled();
  std::vector<Cluster> roots;
  for (int kind = 0; kind < light_kind_count; ++kind) {
    std::vector<Cluster> clusters = record.clusters_of(LightKind(kind));
    if (clusters.empty()) continue;
    record.leave_if_cancelled();
    roots.push_back(config.builder == Builder::greedy
                        ? cluster_greedily(std::move(clusters), record)
                        : cluster_in_local_order(std::move(clusters), record));
  }
  std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  Cluster all = roots.front();
  for (std::size_t i = 1; i < roots.size(); ++i) all = record.join(all, roots[i]);
  record.leave_if_cancelled();
  return {lights, record.laid_out()};
}

} // namespace lightcuts
