// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/cut_chain.h>

#include <algorithm>

#include <lightcuts/core/kernels/contribution_bound.h>

namespace lightcuts {

void CutChain::start(const ShadingBlock& block, ProvenVisibility* proven) {
  block_ = &block;
  proven_ = proven;
  clusters_.assign(1, link(0, {}));
  weight_ = glm::dvec3(1);
  queue_.clear();
  steps_ = 0;
  push(0);
}

CutChain::Link CutChain::link(std::uint32_t node, const ProvenVisibility::Proof& within) const {
  ProvenVisibility::Proof proof = within;
  if (proven_ != nullptr && within.sight == ProvenSight::unknown)
    proof = proven_->prove(tree_->node(node), within);
  if (proof.sight == ProvenSight::hidden) return {node, glm::vec3(0), false, proof};
  const bool is_seen = config_.unoccluded || proof.sight == ProvenSight::seen;
  if (is_seen && tree_->node(node).is_leaf()) return {node, glm::vec3(0), true, proof};
  return {node, contribution_bound(*tree_, node, *block_), false, proof};
}

glm::vec3 CutChain::largest_bound() const {
  glm::vec3 largest(0);
  for (const Link& cluster : clusters_)
    for (int c = 0; c < 3; ++c)
      if (cluster.bound[c] > config_.black_level)
        largest[c] = std::max(largest[c], cluster.bound[c]);
  return largest;
}

void CutChain::advance_to(std::size_t steps) {
  while (steps_ < steps && !ended()) refine();
}

void CutChain::refine() {
  std::pop_heap(queue_.begin(), queue_.end(), after);
  const std::uint32_t place = queue_.back().second;
  queue_.pop_back();
  ++steps_;
  if (is_leaf(place)) {
    clusters_[place].bound = glm::vec3(0);
    clusters_[place].exact = true;
    return;
  }
  const std::uint32_t first = tree_->node(clusters_[place].node).first_child;
  const ProvenVisibility::Proof proof = clusters_[place].proof;
  clusters_[place] = link(first, proof);
  clusters_.push_back(link(first + 1, proof));
  push(place);
  push(static_cast<std::uint32_t>(clusters_.size() - 1));
}

void CutChain::weigh(const glm::dvec3& total) {
  for (int c = 0; c < 3; ++c)
    weight_[c] = 1 / std::max({total[c], double(config_.black_level), 0x1p-800});
  queue_.clear();
  for (std::uint32_t i = 0; i < clusters_.size(); ++i)
    if (const double k = key(clusters_[i].bound); k > 0) queue_.emplace_back(k, i);
  std::make_heap(queue_.begin(), queue_.end(), after);
}

double CutChain::key(const glm::vec3& bound) const {
  return std::max({bound.x * weight_.x, bound.y * weight_.y, bound.z * weight_.z});
}

void CutChain::push(std::uint32_t place) {
  const double k = key(clusters_[place].bound);
  if (k == 0) return;
  queue_.emplace_back(k, place);
  std::push_heap(queue_.begin(), queue_.end(), after);
}

} // namespace lightcuts
