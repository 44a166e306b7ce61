// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/blocks/proven_visibility.h>
#include <lightcuts/core/cut/cut.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// The cuts that a block of shading points goes through, from the root on: each refines the one
/// before, the cluster of the largest bound first, relative to a total that it is told. A leaf is
/// at first a cluster as others are, whose light some points may see for others. A cluster that is
/// proven to be hidden has a bound of 0, and so has a leaf that is proven to be seen. What comes
/// next does not depend on any threshold, so that a point that is content with less stops earlier
/// on the same way.
class CutChain {
public:
  struct Link {
    std::uint32_t node;
    glm::vec3 bound; ///< of what the cluster contributes to any point of the block; 0 if exact
    bool exact;      ///< a leaf that each point sees for itself
    ProvenVisibility::Proof proof = {};
  };

  /// The tree must outlive the chain.
  CutChain(const LightTree& tree, const CutConfig& config) : tree_(&tree), config_(config) {}

  /// Of how many steps the cut is from the root: each refines a cluster into its children, or makes
  /// a leaf exact.
  [[nodiscard]] std::size_t steps() const { return steps_; }

  /// Back to the root, for a block that outlives what is asked until the next start, as does what
  /// has started to prove what its points see; null: nothing.
  void start(const ShadingBlock& block, ProvenVisibility* proven = nullptr);

  /// The cut come to. A cluster keeps its place until it is refined; one of its children takes
  /// that place then, the other the next at the end.
  [[nodiscard]] std::span<const Link> clusters() const { return clusters_; }
  /// No cluster has a bound above 0, or the next in turn has no room for its children.
  [[nodiscard]] bool ended() const {
    return queue_.empty() || (clusters_.size() >= config_.max_size && !is_leaf(front()));
  }
  /// Per channel the largest bound above the black level; 0 where there is none.
  [[nodiscard]] glm::vec3 largest_bound() const;

  /// Goes on until so many steps have been made, or it has ended.
  void advance_to(std::size_t steps);
  /// From here on bounds are compared relative to this total, 0 or more in each channel.
  void weigh(const glm::dvec3& total);

private:
  using Keyed = std::pair<double, std::uint32_t>; ///< key, place

  static bool after(const Keyed& a, const Keyed& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  }
  [[nodiscard]] std::uint32_t front() const { return queue_.front().second; }
  [[nodiscard]] bool is_leaf(std::uint32_t place) const {
    return tree_->node(clusters_[place].node).is_leaf();
  }
  [[nodiscard]] Link link(std::uint32_t node, const ProvenVisibility::Proof& within) const;
  [[nodiscard]] double key(const glm::vec3& bound) const;
  void push(std::uint32_t place);
  void refine();

  const LightTree* tree_;
  CutConfig config_;
  const ShadingBlock* block_ = nullptr;
  ProvenVisibility* proven_ = nullptr;
  std::vector<Link> clusters_;
  std::vector<Keyed> queue_; ///< heap of the clusters with a bound above 0
  glm::dvec3 weight_{1};
  std::size_t steps_ = 0;
};

} // namespace lightcuts
