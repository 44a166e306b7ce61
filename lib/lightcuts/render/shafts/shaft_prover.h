// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <lightcuts/core/blocks/proven_visibility.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/render/shafts/certain_rays.h>
#include <lightcuts/render/shafts/shaft.h>
#include <lightcuts/render/shafts/triangle_tree.h>

namespace lightcuts {

/// By what a BasicShaftProver proves: the library's functions.
struct ShaftRules {
  static Shaft shaft(const Box& from, const Box& to) { return {from, to}; }
  static double margin() { return shaft_margin; }
  static bool misses(const FlatTriangle& triangle, const RayEnds& ends, double separation) {
    return certainly_missed(triangle, ends, separation);
  }
  static bool covers(const FlatTriangle& triangle, const FlatTriangle& partner,
                     const RayEnds& ends) {
    return certainly_covers(triangle, partner, ends);
  }
  static std::uint32_t inherited(const ProvenVisibility::Proof& within) {
    return within.candidates;
  }
};

/// Proves what a group of points sees by shafts between a block of them and a cluster of lights:
/// seen, where each triangle is certain to be missed by all shadow rays; hidden, where one, or two
/// that share their longest edge, block them all. What a shaft has not shown to be out of the way
/// is inherited by those to clusters within, down the tree of triangles. Nothing is proven of
/// directional lights, of rays longer than the mesh and the points are wide, of few points, nor
/// for a block for whose first clusters little was proven.
template <class Rules = ShaftRules>
class BasicShaftProver final : public ProvenVisibility {
public:
  /// origins: where shadow rays of the group start, see VisiblePoint. The tree must outlive this.
  BasicShaftProver(const TriangleTree& tree, std::vector<glm::vec3> origins)
      : tree_(&tree), origins_(std::move(origins)) {}

  void start(std::span<const std::uint32_t> points) override;
  Proof prove(const TreeNode& cluster, const Proof& within) override;

private:
  static constexpr std::uint32_t is_triangle = 0x80000000;
  static constexpr std::size_t most_open = 48; ///< nodes in the way, beyond which none is opened
  static constexpr std::size_t fewest_points = 8;
  static constexpr std::uint32_t first_clusters = 24, fewest_proven = 4;

  struct List {
    std::size_t begin, end; ///< in kept_
  };

  [[nodiscard]] bool gave_up() const {
    return !useful_ || (asked_ >= first_clusters && proven_ < fewest_proven);
  }
  void open(const TriangleTree::Node& node);
  /// Leaves those in kept_, from where it ended, that are in the way; whether one blocks all.
  bool sift(const Shaft& shaft, const List& candidates);

  const TriangleTree* tree_;
  std::vector<glm::vec3> origins_;
  RayEnds ends_;
  double widest_ = 0;
  bool useful_ = false;
  std::uint32_t asked_ = 0, proven_ = 0;
  std::vector<std::uint32_t> kept_; ///< triangles, or nodes with all that they have
  std::vector<List> lists_;
  std::vector<std::uint32_t> work_;
};

using ShaftProver = BasicShaftProver<>;

template <class Rules>
void BasicShaftProver<Rules>::start(std::span<const std::uint32_t> points) {
  asked_ = proven_ = 0;
  kept_.clear();
  lists_.clear();
  useful_ = points.size() >= fewest_points && !tree_->nodes().empty();
  if (!useful_) return;
  std::vector<glm::vec3> origins;
  for (const std::uint32_t p : points) origins.push_back(origins_[p]);
  ends_.start_at(origins);
  Box all = tree_->box();
  all.extend(ends_.from);
  widest_ = glm::distance(glm::dvec3(all.lo), glm::dvec3(all.hi));
  const std::span<const FlatTriangle> triangles = tree_->triangles();
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (may_be_met_edge_on(triangles[i], ends_.from, widest_)) kept_.push_back(i | is_triangle);
  kept_.push_back(0);
  lists_.push_back({0, kept_.size()});
}

template <class Rules>
ProvenVisibility::Proof BasicShaftProver<Rules>::prove(const TreeNode& cluster,
                                                       const Proof& within) {
  if (gave_up() || cluster.is_mixed() || is_at_infinity(cluster.kind()))
    return {ProvenSight::unknown, within.candidates};
  ends_.end_in(cluster.box);
  if (!(ends_.longest <= widest_)) return {ProvenSight::unknown, within.candidates};
  ++asked_;
  const std::size_t begin = kept_.size();
  const bool hidden = sift(Rules::shaft(ends_.from, cluster.box), lists_[Rules::inherited(within)]);
  if (hidden || kept_.size() == begin) {
    kept_.resize(begin);
    ++proven_;
    return {hidden ? ProvenSight::hidden : ProvenSight::seen, within.candidates};
  }
  lists_.push_back({begin, kept_.size()});
  return {ProvenSight::unknown, std::uint32_t(lists_.size() - 1)};
}

template <class Rules>
bool BasicShaftProver<Rules>::sift(const Shaft& shaft, const List& candidates) {
  const auto at = [this](std::size_t place) { return kept_.begin() + std::ptrdiff_t(place); };
  work_.assign(at(candidates.begin), at(candidates.end));
  const std::size_t begin = kept_.size();
  for (std::size_t i = 0; i < work_.size(); ++i) {
    const std::uint32_t one = work_[i];
    if ((one & is_triangle) != 0) {
      const FlatTriangle& triangle = tree_->triangles()[one & ~is_triangle];
      if (Rules::misses(triangle, ends_, shaft.separation(triangle))) continue;
      if (Rules::covers(triangle, triangle, ends_)) return true;
      const FlatTriangle& partner = tree_->triangles()[triangle.partner];
      if (&partner != &triangle && Rules::covers(triangle, partner, ends_)) return true;
      kept_.push_back(one);
      continue;
    }
    const TriangleTree::Node& node = tree_->nodes()[one];
    if (shaft.separation(node.box) > Rules::margin() * reach(ends_, node.box)) continue;
    if (kept_.size() - begin + work_.size() - i <= most_open)
      open(node);
    else
      kept_.push_back(one);
  }
  return false;
}

template <class Rules>
void BasicShaftProver<Rules>::open(const TriangleTree::Node& node) {
  if (node.count == 0) {
    work_.push_back(node.first);
    work_.push_back(node.first + 1);
  }
  for (std::uint32_t k = 0; k < node.count; ++k) work_.push_back((node.first + k) | is_triangle);
}

extern template class BasicShaftProver<ShaftRules>;

} // namespace lightcuts
