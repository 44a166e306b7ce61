// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/block_evidence.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/numerics/exact_dot.h>
#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts {
namespace {

/// In [0, 1), by 53 bits of a hash.
double fraction_of(std::uint64_t hash) { return double(hash >> 11) * 0x1p-53; }

} // namespace

void BlockEvidence::start(std::span<const ShadingPoint* const> points, std::uint64_t seed) {
  points_ = points;
  seed_ = splitmix64(seed);
  stride_ = points.size();
  seen_.clear();
  rays_.assign(points.size(), 0);
}

void BlockEvidence::look(std::span<const CutChain::Link> clusters,
                         std::span<const std::uint32_t> points, const BlockVisibility& visible) {
  constexpr std::size_t fewest = 16; // of whom a quarter speaks for the others
  if (seen_.size() < clusters.size() * stride_) seen_.resize(clusters.size() * stride_);
  for (std::size_t place = 0; place < clusters.size(); ++place) {
    const auto& [node, bound, exact, proof] = clusters[place];
    Seen* const row = &seen_[place * stride_];
    unknown_.clear();
    for (const std::uint32_t p : points)
      if (row[p].node != node) unknown_.push_back(p);
    if (proof.sight == ProvenSight::hidden) {
      for (const std::uint32_t p : unknown_) row[p] = {.node = node, .visible = false};
      continue;
    }
    if (!unknown_.empty()) open_up(node, bound, row);
    if (unoccluded_ || proof.sight == ProvenSight::seen) continue;
    if (exact)
      for (const std::uint32_t p : points)
        if (row[p].taken_over) unknown_.push_back(p);
    std::erase_if(unknown_, [&](std::uint32_t p) { return row[p].open == glm::dvec3(0); });
    if (exact || unknown_.size() < fewest) {
      ask(node, row, unknown_, visible);
      continue;
    }
    const std::uint32_t turn = std::uint32_t(splitmix64(seed_ + node));
    first_.clear();
    others_.clear();
    for (const std::uint32_t p : unknown_)
      (((p + 2 * (p / 8) + turn) & 3) == 0 ? first_ : others_).push_back(p);
    ask(node, row, first_, visible);
    int seen = 0, hidden = 0;
    for (const std::uint32_t p : first_)
      if (row[p].weight > 0) ++(row[p].visible ? seen : hidden);
    // Too few do not speak for others: where the grid that they are on has few of these points, or
    // most lights they drew lie below their horizon.
    if ((seen > 0 && hidden > 0) || std::size_t(seen + hidden) < fewest / 4) {
      ask(node, row, others_, visible);
      continue;
    }
    for (const std::uint32_t p : others_) {
      row[p].visible = hidden == 0;
      row[p].taken_over = true;
    }
  }
}

bool BlockEvidence::look_for_itself(std::span<const CutChain::Link> clusters, std::uint32_t point,
                                    const BlockVisibility& visible) {
  bool any = false;
  for (std::size_t place = 0; place < clusters.size(); ++place) {
    Seen* const row = &seen_[place * stride_];
    if (!row[point].taken_over) continue;
    ask(clusters[place].node, row, {&point, 1}, visible);
    any = true;
  }
  return any;
}

void BlockEvidence::look_closely(std::span<const CutChain::Link> clusters, std::uint32_t point,
                                 const BlockVisibility& visible, std::vector<float>& shares) {
  look_for_itself(clusters, point, visible);
  shares.resize(clusters.size());
  for (std::size_t place = 0; place < clusters.size(); ++place) {
    const std::uint32_t node = clusters[place].node;
    const Seen& own = seen_[place * stride_ + point];
    shares[place] = own.visible ? 1 : 0;
    if (own.open != glm::dvec3(0) && !tree_->node(node).is_leaf() &&
        clusters[place].proof.sight == ProvenSight::unknown)
      shares[place] = share_of_several(node, point, visible, shares[place]);
  }
}

float BlockEvidence::share_of_several(std::uint32_t node, std::uint32_t point,
                                      const BlockVisibility& visible, float otherwise) {
  constexpr int lights = 4; // stratified by intensity
  const double start = fraction_of(splitmix64(splitmix64(seed_ ^ node) + point));
  double all = 0, seen = 0;
  for (int i = 0; i < lights; ++i) {
    Seen one;
    const Draw drawn{(i + start) / lights, point, &one};
    draw(node, 0, 1, {&drawn, 1}, visible);
    all += one.weight;
    if (one.visible) seen += one.weight;
  }
  return all > 0 ? static_cast<float>(seen / all) : otherwise;
}

void BlockEvidence::open_up(std::uint32_t node, const glm::vec3& bound, Seen* row) {
  asked_.clear();
  for (const std::uint32_t p : unknown_) asked_.push_back(points_[p]);
  const bool leaf = tree_->node(node).is_leaf();
  estimates_.assign(unknown_.size(), glm::dvec3(0));
  if (leaf || bound != glm::vec3(0)) centroid_estimates(*tree_, node, asked_, estimates_);
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    const glm::dvec3& open = estimates_[i];
    row[unknown_[i]] = {.open = leaf ? open : glm::min(open, glm::dvec3(bound)), .node = node};
  }
}

void BlockEvidence::ask(std::uint32_t node, Seen* row, std::span<const std::uint32_t> points,
                        const BlockVisibility& visible) {
  constexpr double golden = 0.6180339887498949;
  const double start = fraction_of(splitmix64(seed_ ^ node));
  draws_.clear();
  for (const std::uint32_t p : points) {
    const double u = start + golden * (p + 1);
    draws_.push_back({u - std::floor(u), p, &row[p]});
  }
  std::ranges::sort(draws_, {}, &Draw::u);
  draw(node, 0, 1, draws_, visible);
}

/// Goes down with all draws at once, which are in order: those below the first child's share of
/// [lo, hi) are its.
void BlockEvidence::draw(std::uint32_t node, double lo, double hi, std::span<const Draw> draws,
                         const BlockVisibility& visible) {
  while (!draws.empty() && !tree_->node(node).is_leaf()) {
    const std::uint32_t first = tree_->node(node).first_child;
    const glm::dvec3 &a = tree_->node(first).intensity, &b = tree_->node(first + 1).intensity;
    const double weight = a.x + a.y + a.z;
    const double sum = weight + (b.x + b.y + b.z);
    const double middle = sum > 0 ? lo + (hi - lo) * (weight / sum) : hi;
    std::size_t count = 0;
    while (count < draws.size() && draws[count].u < middle) ++count;
    if (count < draws.size() && count > 0) draw(first, lo, middle, draws.first(count), visible);
    if (count < draws.size()) {
      draws = draws.subspan(count);
      node = first + 1;
      lo = middle;
    } else {
      node = first;
      hi = middle;
    }
  }
  for (const Draw& d : draws) ask_for(tree_->node(node).representative, d.point, *d.into, visible);
}

void BlockEvidence::ask_for(std::uint32_t light, std::uint32_t point, Seen& seen,
                            const BlockVisibility& visible) {
  const ShadingPoint& x = *points_[point];
  const Light& drawn = tree_->lights()[light];
  const glm::vec3 from = viewed_from(drawn.kind, x.position());
  const double n_dot_q = dot_between(x.normal(), from, drawn.position);
  seen.taken_over = false;
  seen.visible = true;
  if (n_dot_q <= 0) return;
  const glm::dvec3 q = glm::dvec3(drawn.position) - glm::dvec3(from);
  const double distance2 = std::max(glm::dot(q, q), tree_->min_distance2());
  seen.weight = n_dot_q / (distance2 * std::sqrt(distance2));
  ++rays_[point];
  seen.visible = visible(point, light);
}

std::uint32_t BlockEvidence::lookers(std::size_t place, std::uint32_t node) const {
  std::uint32_t count = 0;
  for (std::uint32_t p = 0; p < stride_; ++p) count += has_looked(place, node, p) ? 1 : 0;
  return count;
}

glm::dvec3 BlockEvidence::total(std::size_t count, std::uint32_t point) const {
  glm::dvec3 sum(0);
  for (std::size_t place = 0; place < count; ++place) {
    const Seen& seen = seen_[place * stride_ + point];
    if (seen.visible) sum += seen.open;
  }
  return sum;
}

} // namespace lightcuts
