// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/box.h>
#include <lightcuts/cluster_moments.h>
#include <lightcuts/light_set.h>

namespace lightcuts {

/// A cluster of lights: one light (leaf) or the union of its two children.
struct TreeNode {
  Box box;                          ///< of the positions of the cluster's lights, exact
  glm::dvec3 intensity;             ///< their total, W/sr: the rounded sum of the two children's
  std::uint32_t first_child = 0;    ///< the children are first_child and first_child + 1; 0: a leaf
  std::uint32_t representative = 0; ///< index of one of the cluster's lights; one child has it too
  std::uint32_t light_count = 0;

  [[nodiscard]] bool is_leaf() const { return first_child == 0; }
};

/// Binary tree over the lights of one LightSet; node 0 is the root. The two children of a node are
/// neighbours and come after it; every leaf is one light. Keeps its own copy of the lights.
class LightTree {
public:
  LightTree() = default;
  /// nodes as described above; see build() for how to get them.
  LightTree(LightSet lights, std::vector<TreeNode> nodes)
      : lights_(std::move(lights)), nodes_(std::move(nodes)),
        moments_(moments_of(nodes_, lights_)) {
    assert(nodes_.size() == (lights_.empty() ? 0 : 2 * lights_.size() - 1));
  }

  [[nodiscard]] const LightSet& lights() const { return lights_; }
  [[nodiscard]] std::span<const TreeNode> nodes() const { return nodes_; }
  [[nodiscard]] const TreeNode& node(std::uint32_t i) const { return nodes_[i]; }
  [[nodiscard]] const ClusterMoments& moments(std::uint32_t i) const { return moments_[i]; }
  /// No lights, no nodes.
  [[nodiscard]] bool empty() const { return nodes_.empty(); }

private:
  LightSet lights_;
  std::vector<TreeNode> nodes_;
  std::vector<ClusterMoments> moments_;
};

} // namespace lightcuts
