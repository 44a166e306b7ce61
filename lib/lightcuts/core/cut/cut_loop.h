// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/cut/cut.h>
#include <lightcuts/core/cut/visibility.h>
#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/shading/sight.h>

namespace lightcuts {

/// In which order clusters are refined and when that ends, apart from the loop so that the oracle's
/// broken variants can put their own in its place.
struct StoppingRule {
  /// Whether a cluster with this bound is good enough beside the total.
  static bool obeys(const glm::vec3& bound, const glm::dvec3& total, const CutConfig& config) {
    for (int c = 0; c < 3; ++c)
      if (bound[c] > config.threshold * total[c] && bound[c] > config.black_level) return false;
    return true;
  }
  /// Whether a cluster with the first key is refined before one with the second.
  static bool refined_before(double key, double other) { return key > other; }
  /// Whether to stop when the next cluster in turn obeys the threshold.
  template <class AllObey>
  static bool stops(AllObey&& all_obey) {
    return all_obey();
  }
};

/// Picks the cut of a light tree for one shading point after another (Walter et al. 2005, section
/// 3.3). Starts at the root; replaces the cluster of the largest relative bound by its two children
/// until every cluster's bound is, in each channel, at most
///   max(threshold x estimated total, black_level)
/// or max_size is reached. What else is pinned down:
/// - a leaf has bound 0; a channel without light has bound 0;
/// - at a dark point (total 0) refinement ends once every bound is at most black_level;
/// - a cluster is occluded if its representative is, a mixed one as a whole; one below the horizon
///   counts as seen;
/// - no node and no light's visibility is evaluated twice for one point;
/// - the test is made on the total summed anew over the cut, so that nothing drifts;
/// - bounds are compared relative to the total as it was when the size last doubled; between equal
///   ones the older cluster goes first. The threshold has no part in this order (a black level
///   has): a smaller one refines the cut of a larger one.
/// One loop per thread; no allocation once the largest cut has been seen.
template <class Rule>
class CutLoop {
public:
  /// Tree and kernel must outlive the loop. Throws InputError, naming the field, where the
  /// configuration is NaN or out of its domain.
  CutLoop(const LightTree& tree, const CutConfig& config, const ClusterKernel& kernel)
      : tree_(&tree), kernel_(&kernel), config_(config) {
    validate(config);
  }

  /// visible(i) tells whether light i of the LightSet is seen from the point; called only for
  /// lights above the horizon.
  Cut operator()(const ShadingPoint& point, Visibility visible) {
    start();
    if (tree_->empty()) return {};
    select(point, visible);
    return finished(point);
  }

private:
  using Keyed = std::pair<double, std::uint32_t>; ///< key, index into clusters_

  static bool after(const Keyed& a, const Keyed& b) {
    if (a.first != b.first) return Rule::refined_before(b.first, a.first);
    return a.second > b.second;
  }

  void start() {
    clusters_.clear();
    queue_.clear();
    total_ = glm::dvec3(0);
    shadow_rays_ = 0;
    offender_ = 0;
  }

  void select(const ShadingPoint& point, const Visibility& visible) {
    clusters_.push_back({.node = 0, .visible = sees_representative(0, point, visible)});
    kernel_->evaluate(*tree_, point, clusters_);
    rekey();
    while (clusters_.size() < config_.max_size && !done()) {
      refine(point, visible);
      if (clusters_.size() >= 2 * keyed_at_size_) rekey();
    }
  }

  bool sees_representative(std::uint32_t node, const ShadingPoint& point,
                           const Visibility& visible) {
    if (config_.unoccluded) return true;
    const std::uint32_t index = tree_->node(node).representative;
    const Light& light = tree_->lights()[index];
    const glm::vec3 from = viewed_from(light.kind, point.position());
    if (dot_between(point.normal(), from, light.position) <= 0) return true;
    ++shadow_rays_;
    return visible(index);
  }

  /// Refines in one order whatever the threshold, which only tells where to end: so a smaller one
  /// gives a refinement of the same cut.
  bool done() {
    if (queue_.empty()) return true;
    if (!obeys(clusters_[queue_.front().second]) || !obeys(clusters_[offender_])) return false;
    return Rule::stops([this] { return all_obey(); });
  }

  /// Replaces the first cluster of the queue by its children; the one that has its representative
  /// takes its place, its visibility known.
  void refine(const ShadingPoint& point, const Visibility& visible) {
    std::pop_heap(queue_.begin(), queue_.end(), after);
    const std::uint32_t place = queue_.back().second;
    queue_.pop_back();
    const TreeNode& parent = tree_->node(clusters_[place].node);
    std::uint32_t heir = parent.first_child;
    std::uint32_t other = heir + 1;
    if (tree_->node(heir).representative != parent.representative) std::swap(heir, other);

    total_ -= clusters_[place].estimate;
    CutCluster children[] = {
        {.node = heir, .visible = clusters_[place].visible},
        {.node = other, .visible = sees_representative(other, point, visible)}};
    kernel_->evaluate(*tree_, point, children);
    clusters_[place] = children[0];
    clusters_.push_back(children[1]);
    total_ += children[0].estimate + children[1].estimate;
    push(place);
    push(static_cast<std::uint32_t>(clusters_.size() - 1));
  }

  void push(std::uint32_t place) {
    const double k = key(clusters_[place].bound);
    if (k == 0) return;
    queue_.emplace_back(k, place);
    std::push_heap(queue_.begin(), queue_.end(), after);
  }

  [[nodiscard]] double key(const glm::vec3& bound) const {
    return std::max({bound.x * weight_.x, bound.y * weight_.y, bound.z * weight_.z});
  }

  /// Sums the total anew and orders all clusters by their bounds relative to it.
  void rekey() {
    total_ = summed();
    // Such that a key is at most the threshold if and only if its cluster obeys, and finite. At a
    // threshold of 0 a black level is all that counts.
    const bool is_relative = config_.threshold > 0 || config_.black_level == 0;
    const double black =
        config_.threshold > 0 ? double(config_.black_level) / config_.threshold : 0;
    for (int c = 0; c < 3; ++c)
      weight_[c] = is_relative ? 1 / std::max({total_[c], black, 0x1p-800}) : 1;
    keyed_at_size_ = clusters_.size();
    queue_.clear();
    for (std::uint32_t i = 0; i < clusters_.size(); ++i)
      if (const double k = key(clusters_[i].bound); k > 0) queue_.emplace_back(k, i);
    std::make_heap(queue_.begin(), queue_.end(), after);
  }

  [[nodiscard]] glm::dvec3 summed() const {
    glm::dvec3 sum(0);
    for (const CutCluster& c : clusters_) sum += c.estimate;
    return sum;
  }

  [[nodiscard]] bool obeys(const CutCluster& cluster) const {
    return Rule::obeys(cluster.bound, total_, config_);
  }

  /// On the total summed anew. Keeps in mind who does not.
  bool all_obey() {
    total_ = summed();
    for (offender_ = 0; offender_ < clusters_.size(); ++offender_)
      if (!obeys(clusters_[offender_])) return false;
    offender_ = 0;
    return true;
  }

  /// Estimate and truth lie between lower and upper bound; the lower one is 0 where light may be
  /// occluded.
  [[nodiscard]] glm::dvec3 error_bound(const CutCluster& c, const ShadingPoint& point) const {
    const glm::dvec3 high(c.bound);
    if (!config_.unoccluded || c.bound == glm::vec3(0)) return high;
    const glm::dvec3 low(kernel_->lower_bound(*tree_, c.node, point));
    const glm::dvec3 bound = glm::max(c.estimate - low, high - c.estimate);
    return glm::min(high, bound);
  }

  [[nodiscard]] bool needed_black_level() const {
    return std::any_of(clusters_.begin(), clusters_.end(), [this](const CutCluster& c) {
      return c.bound.x > config_.threshold * total_.x || c.bound.y > config_.threshold * total_.y ||
             c.bound.z > config_.threshold * total_.z;
    });
  }

  Cut finished(const ShadingPoint& point) {
    Cut cut;
    const bool obeyed = all_obey();
    if (!obeyed)
      cut.end = CutEnd::max_size;
    else if (config_.black_level > 0 && needed_black_level())
      cut.end = CutEnd::black_level;
    glm::dvec3 error(0);
    for (const CutCluster& c : clusters_) error += error_bound(c, point);
    for (int c = 0; c < 3; ++c) {
      cut.radiance[c] = to_float(total_[c]);
      cut.certified_error[c] = certified_error(total_[c], error[c]);
    }
    cut.clusters = clusters_;
    cut.shadow_rays = shadow_rays_;
    return cut;
  }

  const LightTree* tree_;
  const ClusterKernel* kernel_;
  CutConfig config_;
  std::vector<CutCluster> clusters_;
  std::vector<Keyed> queue_; ///< heap of the clusters with a bound above 0
  glm::dvec3 total_{0};
  glm::dvec3 weight_{1};
  std::size_t keyed_at_size_ = 1;
  std::uint32_t shadow_rays_ = 0;
  std::size_t offender_ = 0; ///< a cluster that may not obey; while it does not, all need no look
};

} // namespace lightcuts
