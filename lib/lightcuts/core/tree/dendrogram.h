// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/tree/cluster.h>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/core/tree/tree_builder.h>

namespace lightcuts {

/// The record of a clustering: which clusters were merged with which. Starts with the lights, each
/// a cluster of its own; complete after one merge less than there are lights.
class Dendrogram {
public:
  /// lights: at least one, to be kept alive; config: what it says of representatives and of being
  /// cancelled.
  Dendrogram(const LightSet& lights, const BuildConfig& config);

  /// The lights of one kind.
  [[nodiscard]] std::vector<Cluster> clusters_of(LightKind kind) const;
  /// Throws Cancelled.
  void leave_if_cancelled() const { config_.progress.leave_if_cancelled(); }
  /// Merges two clusters that were not merged before. Throws Cancelled.
  Cluster join(Cluster a, Cluster b);
  /// As LightTree wants it: node 0 the root, siblings together, parents before children.
  [[nodiscard]] std::vector<TreeNode> laid_out() const;

private:
  using Children = std::pair<std::uint32_t, std::uint32_t>;

  [[nodiscard]] bool takes_first(const Cluster& a, const Cluster& b) const;

  const LightSet& lights_;
  const BuildConfig& config_;
  std::vector<TreeNode> nodes_; ///< the lights, then the merged clusters
  std::vector<Children> children_;
};

} // namespace lightcuts
