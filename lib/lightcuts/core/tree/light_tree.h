// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/tree/cluster_emission.h>
#include <lightcuts/core/tree/cluster_moments.h>

namespace lightcuts {

/// A cluster of lights: one light (leaf) or the union of its two children. What a cut reads of it
/// lies in one cache line.
struct alignas(64) TreeNode {
  Box box;                          ///< of Light::position of the cluster's lights, exact
  glm::dvec3 intensity;             ///< their total, W/sr: the rounded sum of the two children's
  std::uint32_t first_child = 0;    ///< the children are first_child and first_child + 1; 0: a leaf
  std::uint32_t representative = 0; ///< index of one of the cluster's lights; one child has it too
  std::uint32_t light_count = 0;
  LightKinds kinds = only(LightKind::omni); ///< of the cluster's lights

  [[nodiscard]] bool is_leaf() const { return first_child == 0; }
  /// Lights of several kinds, which only clusters at the top of a tree have: their box, moments and
  /// emission mean nothing.
  [[nodiscard]] bool is_mixed() const { return (kinds & (kinds - 1)) != 0; }
  /// The kind of all lights of a cluster that is not mixed.
  [[nodiscard]] LightKind kind() const {
    for (int k = 1; k < light_kind_count; ++k)
      if (kinds == only(LightKind(k))) return LightKind(k);
    return LightKind::omni;
  }
};
static_assert(sizeof(TreeNode) == 64);

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
    if ((lights_.kinds() & kinds_with_axis) != 0) emission_ = emission_of(nodes_, lights_);
  }

  [[nodiscard]] const LightSet& lights() const { return lights_; }
  [[nodiscard]] std::span<const TreeNode> nodes() const { return nodes_; }
  [[nodiscard]] const TreeNode& node(std::uint32_t i) const { return nodes_[i]; }
  [[nodiscard]] const ClusterMoments& moments(std::uint32_t i) const { return moments_[i]; }
  /// Only where there are oriented lights or spots.
  [[nodiscard]] const ClusterEmission& emission(std::uint32_t i) const { return emission_[i]; }
  /// Square of LightSet::min_distance(), m^2; 0: no clamp.
  [[nodiscard]] double min_distance2() const {
    return double(lights_.min_distance()) * lights_.min_distance();
  }
  /// No lights, no nodes.
  [[nodiscard]] bool empty() const { return nodes_.empty(); }

private:
  LightSet lights_;
  std::vector<TreeNode> nodes_;
  std::vector<ClusterMoments> moments_;
  std::vector<ClusterEmission> emission_; ///< empty where no light has an axis
};

} // namespace lightcuts
