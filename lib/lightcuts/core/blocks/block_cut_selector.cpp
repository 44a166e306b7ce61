// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/block_cut_selector.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts {
namespace {

/// After how many steps points may stop next: a twelfth more, so that a cut is larger than it need
/// be by no more than that, and few look at clusters that are refined at once.
std::size_t next_stop(std::size_t steps) { return steps + std::max<std::size_t>(1, steps / 12); }

/// Whether all points look at this cut even if none of the samples would stop here.
bool is_census(std::size_t before, std::size_t steps) {
  for (std::size_t census = 64; census <= steps; census *= 4)
    if (before < census) return true;
  return false;
}

double mean_of(const glm::dvec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }

} // namespace

BlockCutSelector::BlockCutSelector(const LightTree& tree, const CutConfig& config,
                                   std::uint64_t seed)
    : tree_(&tree), config_(config), seed_(splitmix64(seed)), chain_(tree, config),
      evidence_(tree, config.unoccluded) {
  validate(config);
}

std::span<const BlockCut>
BlockCutSelector::operator()(std::span<const BlockPoint> points, std::uint64_t query,
                             const BlockVisibility& visible,
                             std::vector<std::vector<CutCluster>>* clusters) {
  all_ = points;
  query_ = query;
  record_ = clusters;
  cuts_.assign(points.size(), {});
  if (record_ != nullptr) record_->assign(points.size(), {});
  if (tree_->empty()) return cuts_;
  const auto from_member = [&](std::uint32_t p, std::uint32_t light) {
    return visible(members_[p], light);
  };
  const BlockVisibility by_members(from_member, visible.proven());
  visible_ = &by_members;
  for (Members& group : groups_of_like_lobes(points)) light(std::move(group));
  return cuts_;
}

void BlockCutSelector::light(Members members) {
  members_ = std::move(members);
  points_.clear();
  places_.clear();
  std::vector<ShadingPoint> copies;
  for (const std::uint32_t i : members_) {
    points_.push_back(&all_[i].point);
    places_.push_back(all_[i].place);
    copies.push_back(all_[i].point);
  }
  const auto last = std::uint32_t(members_.size() - 1);
  samples_ = {0, last / 3, last - last / 3, last};
  samples_.erase(std::unique(samples_.begin(), samples_.end()), samples_.end());

  constexpr double widest_chord2 = 0.5; // of the cone of normals: 41 degrees about its axis
  const ShadingBlock block(copies);
  if (members_.size() == 1 || block.directions().normals.chord2 <= widest_chord2) {
    if (walk(block)) return;
    for (std::uint32_t p = 0; p < members_.size(); ++p)
      cuts_[members_[p]].shadow_rays += evidence_.shadow_rays(p);
  }
  auto [near, far] = parted(all_, members_);
  light(std::move(near));
  light(std::move(far));
}

bool BlockCutSelector::walk(const ShadingBlock& block) {
  evidence_.start(points_, splitmix64(seed_ ^ query_) + members_.front());
  ProvenVisibility* const proven = visible_->proven();
  if (proven != nullptr) proven->start(members_); // who are together, whether it is asked or not
  chain_.start(block, config_.unoccluded ? nullptr : proven);
  block_ = &block;
  lows_.clear();
  share_.start(places_);
  Members open(points_.size());
  std::iota(open.begin(), open.end(), 0U);
  std::size_t weighed_at = 0, before = 0;
  bool all_look = points_.size() <= samples_.size(), was_judged = false;
  while (!open.empty()) {
    const std::size_t steps = chain_.steps();
    const bool is_judged = steps >= 8 || chain_.ended();
    if (!was_judged && is_judged && points_.size() > 1 && is_too_loose()) return false;
    was_judged = is_judged;
    largest_bound_ = chain_.largest_bound();
    const bool weighs = steps >= 2 * weighed_at;
    if (!all_look || weighs) {
      glm::dvec3 mean(0);
      if (ask_samples(mean)) all_look = true;
      if (weighs) {
        chain_.weigh(mean);
        weighed_at = std::max<std::size_t>(1, steps);
      }
    }
    // Nobody stops before it is known whether the block stays together, so that this does not
    // depend on the threshold.
    if (is_judged && (all_look || chain_.ended() || is_census(before, steps))) settle(open);
    before = steps;
    chain_.advance_to(next_stop(steps));
  }
  return true;
}

bool BlockCutSelector::is_too_loose() const {
  constexpr double most = 1.5; // times those of the point where they are largest
  double of_block = 0, of_points = 0;
  for (const CutChain::Link& c : chain_.clusters()) of_block += mean_of(c.bound);
  for (const std::uint32_t p : samples_) {
    double own = 0;
    for (const CutChain::Link& c : chain_.clusters())
      if (c.bound != glm::vec3(0)) own += mean_of(contribution_bound(*tree_, c.node, *points_[p]));
    of_points = std::max(of_points, own);
  }
  return of_block > most * of_points;
}

bool BlockCutSelector::ask_samples(glm::dvec3& mean) {
  evidence_.look(chain_.clusters(), samples_, *visible_);
  bool any = false;
  for (const std::uint32_t p : samples_) {
    const glm::dvec3 total = evidence_.total(chain_.clusters().size(), p);
    mean += total / double(samples_.size());
    any = any || obeys(total);
  }
  return any;
}

bool BlockCutSelector::obeys(const glm::dvec3& total) const {
  for (int c = 0; c < 3; ++c)
    if (largest_bound_[c] > config_.threshold * total[c]) return false;
  return true;
}

void BlockCutSelector::settle(Members& open) {
  evidence_.look(chain_.clusters(), open, *visible_);
  group_.clear();
  for (const std::uint32_t p : open)
    if (chain_.ended() || obeys(evidence_.total(chain_.clusters().size(), p))) group_.push_back(p);
  if (group_.empty()) return;
  bound_sum_ = glm::dvec3(0);
  for (const CutChain::Link& c : chain_.clusters())
    if (!is_seen(c)) bound_sum_ += glm::dvec3(c.bound);
  bound_below();
  if (config_.unoccluded)
    for (const std::uint32_t p : group_)
      finish(p, evidence_.total(chain_.clusters().size(), p), nullptr, 0);
  else
    share_out(open);
  Members left;
  std::ranges::set_difference(open, group_, std::back_inserter(left));
  open = std::move(left);
}

/// Of what the shares of a cut differ from what one point saw of its clusters. Means of channels.
struct BlockCutSelector::Deviation {
  double moved = 0;        ///< the sum
  double up = 0, down = 0; ///< the largest and the smallest of it, 0 among them
  double variance = 0;     ///< of the sum, if the shares are right

  void add(double light, double share, double own) {
    const double by = light * (share - own);
    moved += by;
    up = std::max(up, by);
    down = std::min(down, by);
    variance += light * light * share * (1 - share);
  }
  /// Whether the sum is more than so many deviations, without the cluster that counts most: one
  /// that is seen by all but few points has an error that no deviation tells.
  [[nodiscard]] bool exceeds(double deviations) const {
    const double rest = moved > 0 ? moved - up : moved - down;
    return rest * rest > deviations * deviations * variance;
  }
};

BlockCutSelector::Deviation BlockCutSelector::deviation_of(std::uint32_t p, const float* shares,
                                                           std::size_t stride) const {
  Deviation deviation;
  for (std::size_t place = 0; place < chain_.clusters().size(); ++place)
    deviation.add(mean_of(evidence_.open(place, p)), double(shares[place * stride]),
                  evidence_.sees(place, p) ? 1 : 0);
  return deviation;
}

bool BlockCutSelector::wants_to_look_closely(std::uint32_t p, const float* shares,
                                             std::size_t stride, double total) {
  constexpr double doubtful = 1.5, contradicted = 2.5; // deviations
  constexpr double noisy = 0.05;                       // deviation relative to the total
  Deviation deviation = deviation_of(p, shares, stride);
  if (deviation.exceeds(doubtful) && evidence_.look_for_itself(chain_.clusters(), p, *visible_))
    deviation = deviation_of(p, shares, stride);
  return deviation.exceeds(contradicted) ||
         std::sqrt(deviation.variance) > std::max(noisy, double(config_.threshold)) * total;
}

void BlockCutSelector::share_out(const Members& lookers) {
  share_.observe(evidence_, chain_.clusters(), lookers);
  const std::size_t count = chain_.clusters().size(), stride = group_.size();
  shares_.resize(count * stride);
  for (std::size_t place = 0; place < count; ++place) {
    const std::span<float> shares = std::span(shares_).subspan(place * stride, stride);
    const CutChain::Link& cluster = chain_.clusters()[place];
    if (tree_->node(cluster.node).is_leaf() || cluster.proof.sight != ProvenSight::unknown)
      for (std::size_t i = 0; i < stride; ++i)
        shares[i] = evidence_.sees(place, group_[i]) ? 1.0F : 0.0F;
    else
      share_.at(place, group_, shares);
  }
  Members done;
  for (std::size_t i = 0; i < stride; ++i) {
    const std::uint32_t p = group_[i];
    float* const shares = &shares_[i];
    glm::dvec3 total = total_of(p, shares, stride);
    if (wants_to_look_closely(p, shares, stride, mean_of(total))) {
      evidence_.look_closely(chain_.clusters(), p, *visible_, closely_);
      for (std::size_t place = 0; place < count; ++place) shares[place * stride] = closely_[place];
      total = total_of(p, shares, stride);
    }
    if (!chain_.ended() && !obeys(total)) continue;
    finish(p, total, shares, stride);
    done.push_back(p);
  }
  group_ = std::move(done);
}

glm::dvec3 BlockCutSelector::total_of(std::uint32_t p, const float* shares,
                                      std::size_t stride) const {
  glm::dvec3 total(0);
  for (std::size_t place = 0; place < chain_.clusters().size(); ++place)
    total += evidence_.open(place, p) * double(shares[place * stride]);
  return total;
}

CutEnd BlockCutSelector::end_of(std::uint32_t p, const glm::dvec3& total) const {
  if (obeys(total) && config_.black_level == 0) return CutEnd::converged;
  // By the point's own bounds, which may be smaller than those of the block.
  CutEnd end = CutEnd::converged;
  for (const CutChain::Link& cluster : chain_.clusters()) {
    if (cluster.bound == glm::vec3(0)) continue;
    const glm::vec3 own =
        glm::min(cluster.bound, contribution_bound(*tree_, cluster.node, *points_[p]));
    for (int c = 0; c < 3; ++c) {
      if (own[c] <= config_.threshold * total[c]) continue;
      if (own[c] > config_.black_level) return CutEnd::max_size;
      end = CutEnd::black_level;
    }
  }
  return end;
}

void BlockCutSelector::bound_below() {
  lows_.resize(chain_.clusters().size());
  for (std::size_t place = 0; place < lows_.size(); ++place) {
    const CutChain::Link& cluster = chain_.clusters()[place];
    if (is_seen(cluster) && lows_[place].node != cluster.node)
      lows_[place] = {cluster.node, contribution_lower_bound(*tree_, cluster.node, *block_)};
  }
}

glm::dvec3 BlockCutSelector::error_bound(std::uint32_t p) const {
  glm::dvec3 sum = bound_sum_;
  // Estimate and truth lie between lower and upper bound.
  for (std::size_t place = 0; place < chain_.clusters().size(); ++place) {
    const CutChain::Link& cluster = chain_.clusters()[place];
    if (cluster.bound == glm::vec3(0) || !is_seen(cluster)) continue;
    const glm::dvec3 high(cluster.bound);
    const glm::dvec3 low(lows_[place].bound);
    const glm::dvec3 estimate = evidence_.open(place, p);
    sum += glm::min(high, glm::max(estimate - low, high - estimate));
  }
  return sum;
}

void BlockCutSelector::finish(std::uint32_t p, const glm::dvec3& total, const float* shares,
                              std::size_t stride) {
  const auto clusters = chain_.clusters();
  BlockCut& cut = cuts_[members_[p]];
  cut.size = std::uint32_t(clusters.size());
  cut.shadow_rays += evidence_.shadow_rays(p);
  cut.end = end_of(p, total);
  const glm::dvec3 error = error_bound(p);
  for (int c = 0; c < 3; ++c) {
    cut.radiance[c] = to_float(total[c]);
    cut.certified_error[c] = certified_error(total[c], error[c]);
  }
  if (record_ == nullptr) return;
  for (std::size_t place = 0; place < clusters.size(); ++place) {
    const float own = evidence_.sees(place, p) ? 1.0F : 0.0F;
    const double share = shares != nullptr ? shares[place * stride] : own;
    (*record_)[members_[p]].push_back(
        {clusters[place].node, share > 0, evidence_.open(place, p) * share, clusters[place].bound});
  }
}

} // namespace lightcuts
