// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/blocks/block_evidence.h>
#include <lightcuts/core/blocks/block_visibility.h>
#include <lightcuts/core/blocks/cut_chain.h>
#include <lightcuts/core/blocks/neighbours.h>
#include <lightcuts/core/blocks/visible_share.h>
#include <lightcuts/core/cut/cut.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// What a BlockCutSelector found for one point; as Cut has it.
struct BlockCut {
  glm::vec3 radiance{0};
  glm::vec3 certified_error{0}; ///< >= |radiance - exact|, rounding included
  std::uint32_t size = 0;       ///< clusters
  std::uint32_t shadow_rays = 0;
  CutEnd end = CutEnd::converged;
};

/// Picks cuts for neighbouring shading points together. Points are put into blocks of like lobes
/// and normals; those of a block go down one CutChain, by bounds that hold for all of them, and
/// each stops at the first of some cuts where every cluster's bound is, in each channel, at most
///   max(threshold x the point's total, black_level)
/// or max_size is reached. So each has a cut of its own, a partition of the lights, that obeys the
/// threshold as the cut of a CutSelector does.
///
/// Which share of a cluster is seen is estimated over the points of a block, each of which asks for
/// another light of the cluster: see BlockEvidence and VisibleShare. A point whose own evidence
/// contradicts these shares, or to which they leave too much chance, asks for several lights of
/// each cluster and keeps to what it saw itself. A smaller threshold refines a cut but for what a
/// share changes by the points that look at a cluster with it. Where BlockVisibility::proven()
/// tells that a block sees a cluster or does not, nobody asks, and the error certified is of what
/// is known: two-sided where it is seen, 0 where it is hidden. One selector per thread.
class BlockCutSelector {
public:
  /// The tree must outlive the selector. Throws InputError, naming the field, where the
  /// configuration is NaN or out of its domain. seed: of which light a point asks for.
  explicit BlockCutSelector(const LightTree& tree, const CutConfig& config = {},
                            std::uint64_t seed = 1);

  /// query: a number of its own for each group of points. visible(p, light) tells whether the light
  /// of the LightSet is seen from points[p]; called only for lights above the horizon. A cut for
  /// each point, valid until the next call; clusters, where not null, takes those of each.
  std::span<const BlockCut> operator()(std::span<const BlockPoint> points, std::uint64_t query,
                                       const BlockVisibility& visible,
                                       std::vector<std::vector<CutCluster>>* clusters = nullptr);

private:
  void light(Members members);
  /// Goes down the chain until all points have their cut; false: the block is to be parted.
  bool walk(const ShadingBlock& block);
  /// Whether the block's bounds are much larger than those of its points alone.
  [[nodiscard]] bool is_too_loose() const;
  /// The mean total of the samples, and whether the brightest of them may stop.
  bool ask_samples(glm::dvec3& mean);
  /// Finishes those of the open points that may stop at this cut.
  void settle(Members& open);
  /// Finishes those in group_, who are left there, by shares; lookers: all that look at this cut.
  void share_out(const Members& lookers);
  // Of a point, by its shares of the clusters, each `stride` after the one before:
  struct Deviation;
  [[nodiscard]] Deviation deviation_of(std::uint32_t p, const float* shares,
                                       std::size_t stride) const;
  /// Whether its own evidence contradicts the shares, or these are too uncertain.
  bool wants_to_look_closely(std::uint32_t p, const float* shares, std::size_t stride,
                             double total);
  [[nodiscard]] glm::dvec3 total_of(std::uint32_t p, const float* shares, std::size_t stride) const;
  void finish(std::uint32_t p, const glm::dvec3& total, const float* shares, std::size_t stride);
  [[nodiscard]] bool obeys(const glm::dvec3& total) const;
  [[nodiscard]] CutEnd end_of(std::uint32_t p, const glm::dvec3& total) const;
  /// Sees to it that lows_ are those of this cut.
  void bound_below();
  [[nodiscard]] glm::dvec3 error_bound(std::uint32_t p) const;
  /// Whether no point of the block can fail to see the cluster.
  [[nodiscard]] bool is_seen(const CutChain::Link& cluster) const {
    return config_.unoccluded || cluster.proof.sight == ProvenSight::seen;
  }

  const LightTree* tree_;
  CutConfig config_;
  std::uint64_t seed_;
  CutChain chain_;
  BlockEvidence evidence_;
  VisibleShare share_;

  // Of the call.
  std::span<const BlockPoint> all_;
  std::uint64_t query_ = 0;
  const BlockVisibility* visible_ = nullptr;
  std::vector<std::vector<CutCluster>>* record_ = nullptr;
  std::vector<BlockCut> cuts_;

  // Of the block; p is an index into these.
  Members members_; ///< indices into all_
  std::vector<const ShadingPoint*> points_;
  std::vector<glm::vec2> places_;
  Members samples_; ///< some p

  const ShadingBlock* block_ = nullptr;

  // Of the cut that the chain has come to.
  glm::vec3 largest_bound_{0}; ///< above the black level
  glm::dvec3 bound_sum_{0};    ///< of those that are not proven to be seen
  struct Low {
    std::uint32_t node = 0xffffffff;
    glm::vec3 bound{0};
  };
  std::vector<Low> lows_;      ///< lower bounds of those that are seen, by place in the cut
  Members group_;              ///< p
  std::vector<float> closely_; ///< by place in the cut
  std::vector<float> shares_;  ///< by place in the cut, then in the group
};

} // namespace lightcuts
