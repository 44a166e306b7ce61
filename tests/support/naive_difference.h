// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lightcuts/core/tree/light_tree.h>
#include <oracle/truth/naive_tree.h>

namespace lightcuts {

/// Empty where the subtree is what the naive clusters are, to the bit; else what differs.
inline std::string difference(const LightTree& tree, std::uint32_t i,
                              const std::vector<oracle::NaiveCluster>& clusters, std::size_t at) {
  const oracle::NaiveCluster& naive = clusters[at];
  const TreeNode& node = tree.node(i);
  if (node.box != naive.box) return "box";
  if (node.intensity != naive.intensity) return "intensity";
  if (node.is_leaf() != (naive.children[0] < 0)) return "topology";
  if (node.is_leaf()) return node.representative == naive.first ? "" : "order of lights";
  for (std::uint32_t child = 0; child < 2; ++child)
    if (auto d = difference(tree, node.first_child + child, clusters,
                            std::size_t(naive.children[child]));
        !d.empty())
      return d;
  return "";
}

/// How the trees differ from their roots on, "" where they do not; the last cluster is the root of
/// the naive tree.
inline std::string difference(const LightTree& tree,
                              const std::vector<oracle::NaiveCluster>& clusters) {
  return difference(tree, 0, clusters, clusters.size() - 1);
}

} // namespace lightcuts
