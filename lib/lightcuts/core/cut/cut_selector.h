// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kernels/cluster_estimate.h>
#include <lightcuts/core/kernels/contribution.h>
#include <lightcuts/core/kernels/error_bound.h>
#include <lightcuts/core/kernels/features.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

struct CutConfig {
  float threshold = 0.01F;       ///< error bound per cluster, relative to the total; default 0.01
  std::uint32_t max_size = 1000; ///< largest number of clusters in a cut, >= 1; default 1000
  float black_level = 0;         ///< a bound up to this radiance is always good enough; default 0
  /// Nothing comes between the point and any light: `visible` is not called, and the certified
  /// error, which has lower bounds then, is smaller; default false
  bool unoccluded = false;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("threshold", &CutConfig::threshold, domain::not_negative);
    field("max_size", &CutConfig::max_size, domain::within(1, 0xffffffff));
    field("black_level", &CutConfig::black_level, domain::not_negative);
    field("unoccluded", &CutConfig::unoccluded);
  }
  bool operator==(const CutConfig&) const = default;
};

/// Throws InputError, naming the field: threshold and black_level are >= 0, max_size >= 1.
inline void validate(const CutConfig& config) {
  if (!(config.threshold >= 0))
    throw InputError("threshold: must be a number that is not negative");
  if (!(config.black_level >= 0))
    throw InputError("black_level: must be a number that is not negative");
  if (config.max_size == 0) throw InputError("max_size: a cut has at least 1 cluster");
}

/// One cluster of a cut.
struct CutCluster {
  std::uint32_t node;
  bool visible;        ///< whether its representative is seen
  glm::dvec3 estimate; ///< radiance that it is taken to contribute, occlusion included
  glm::vec3 bound;     ///< of the error of that, radiance; 0 for a leaf
};

/// Why refinement ended.
enum class CutEnd {
  converged,   ///< every bound obeys the threshold
  black_level, ///< every bound obeys the threshold or is at most black_level, and one needed that
  max_size     ///< the largest size was reached first
};

/// What a CutSelector found; valid until its next call.
struct Cut {
  glm::vec3 radiance{0};                ///< sum of the estimates; +inf above the largest float
  glm::vec3 certified_error{0};         ///< >= |radiance - exact|, rounding included
  std::span<const CutCluster> clusters; ///< a partition of the lights
  std::uint32_t shadow_rays = 0;        ///< calls of `visible`
  CutEnd end = CutEnd::converged;
};

/// The parts of the algorithm that decide its correctness, apart so that other methods, and the
/// oracle's broken ones, can put their own in their place. lobe is that of the point's material.
template <class TheFeatures>
struct BasicLightcutsRules {
  using Features = TheFeatures;

  /// Upper bound of the cluster's contribution.
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    return contribution_bound<Features>(tree, node, point, lobe);
  }
  /// What the cluster is taken to contribute if its representative is seen; between 0 and `bound`
  /// (of a leaf: exact). Evaluated at the centroid of intensity, not at the representative.
  template <class OneLobe>
  static glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             const OneLobe& lobe, const glm::vec3& bound) {
    const glm::dvec3 e = cluster_estimate<Features>(tree, node, point, lobe);
    return tree.node(node).is_leaf() ? e : glm::min(e, glm::dvec3(bound));
  }
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

/// For any scene.
using LightcutsRules = BasicLightcutsRules<AnyFeatures>;

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
/// One selector per thread; no allocation once the largest cut has been seen.
template <class Rules>
class BasicCutSelector {
public:
  /// The tree must outlive the selector. Throws InputError, naming the field, where the
  /// configuration is NaN or out of its domain.
  explicit BasicCutSelector(const LightTree& tree, const CutConfig& config = {}, Rules rules = {})
      : tree_(&tree), config_(config), rules_(std::move(rules)) {
    validate(config);
  }

  /// visible(i) tells whether light i of the LightSet is seen from the point; called only for
  /// lights above the horizon.
  template <class Visible>
  Cut operator()(const ShadingPoint& point, Visible&& visible) {
    start();
    if (tree_->empty()) return {};
    std::visit([&](const auto& lobe) { select(point, lobe, visible); }, point.material().lobe);
    return finished(point);
  }

private:
  using Features = typename Rules::Features;
  using Keyed = std::pair<double, std::uint32_t>; ///< key, index into clusters_

  static bool after(const Keyed& a, const Keyed& b) {
    if (a.first != b.first) return Rules::refined_before(b.first, a.first);
    return a.second > b.second;
  }

  void start() {
    clusters_.clear();
    queue_.clear();
    total_ = glm::dvec3(0);
    shadow_rays_ = 0;
    offender_ = 0;
  }

  template <class OneLobe, class Visible>
  void select(const ShadingPoint& point, const OneLobe& lobe, Visible& visible) {
    clusters_.push_back(evaluated(0, sees_representative(0, point, visible), point, lobe));
    rekey();
    while (clusters_.size() < config_.max_size && !done()) {
      refine(point, lobe, visible);
      if (clusters_.size() >= 2 * keyed_at_size_) rekey();
    }
  }

  /// All calls in one piece: 6 % off the time of a frame.
  template <class OneLobe>
  [[gnu::flatten]] CutCluster evaluated(std::uint32_t node, bool is_visible,
                                        const ShadingPoint& point, const OneLobe& lobe) const {
    const bool leaf = tree_->node(node).is_leaf();
    const glm::vec3 bound = leaf ? glm::vec3(0) : rules_.bound(*tree_, node, point, lobe);
    glm::dvec3 estimate(0);
    if (is_visible && (leaf || bound != glm::vec3(0)))
      estimate = rules_.estimate(*tree_, node, point, lobe, bound);
    return {node, is_visible, estimate, bound};
  }

  [[nodiscard]] bool unoccluded() const {
    if constexpr (Features::occludes) return config_.unoccluded;
    return true;
  }

  template <class Visible>
  bool sees_representative(std::uint32_t node, const ShadingPoint& point, Visible& visible) {
    if (unoccluded()) return true;
    const std::uint32_t index = tree_->node(node).representative;
    const Light& light = tree_->lights()[index];
    const glm::vec3 from = viewed_from(Features::known(light.kind), point.position());
    if (dot_between(point.normal(), from, light.position) <= 0) return true;
    ++shadow_rays_;
    return visible(index);
  }

  /// Refines in one order whatever the threshold, which only tells where to end: so a smaller one
  /// gives a refinement of the same cut.
  bool done() {
    if (queue_.empty()) return true;
    if (!obeys(clusters_[queue_.front().second]) || !obeys(clusters_[offender_])) return false;
    return rules_.stops([this] { return all_obey(); });
  }

  /// Replaces the first cluster of the queue by its children; the one that has its representative
  /// takes its place, its visibility known.
  template <class OneLobe, class Visible>
  void refine(const ShadingPoint& point, const OneLobe& lobe, Visible& visible) {
    std::pop_heap(queue_.begin(), queue_.end(), after);
    const std::uint32_t place = queue_.back().second;
    queue_.pop_back();
    const TreeNode& parent = tree_->node(clusters_[place].node);
    std::uint32_t heir = parent.first_child;
    std::uint32_t other = heir + 1;
    if (tree_->node(heir).representative != parent.representative) std::swap(heir, other);

    const CutCluster& parent_cluster = clusters_[place];
    total_ -= parent_cluster.estimate;
    clusters_[place] = evaluated(heir, parent_cluster.visible, point, lobe);
    clusters_.push_back(evaluated(other, sees_representative(other, point, visible), point, lobe));
    total_ += clusters_[place].estimate + clusters_.back().estimate;
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
    return rules_.obeys(cluster.bound, total_, config_);
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
    if (!unoccluded() || c.bound == glm::vec3(0)) return high;
    const glm::dvec3 low(contribution_lower_bound<Features>(*tree_, c.node, point));
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
  CutConfig config_;
  [[no_unique_address]] Rules rules_;
  std::vector<CutCluster> clusters_;
  std::vector<Keyed> queue_; ///< heap of the clusters with a bound above 0
  glm::dvec3 total_{0};
  glm::dvec3 weight_{1};
  std::size_t keyed_at_size_ = 1;
  std::uint32_t shadow_rays_ = 0;
  std::size_t offender_ = 0; ///< a cluster that may not obey; while it does not, all need no look
};

/// For any scene; with_features() finds a narrower BasicCutSelector<BasicLightcutsRules<Features>>,
/// which gives the same bits sooner.
using CutSelector = BasicCutSelector<LightcutsRules>;

} // namespace lightcuts
