// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/dendrogram.h>

#include <cmath>

#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts {
namespace {

double sum_of_channels(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// Uniform in [0, 1), the same for the same arguments.
double hashed_uniform(std::uint64_t seed, std::uint32_t a, std::uint32_t b) {
  const std::uint64_t pair = (std::uint64_t(a) << 32) | b;
  return double(splitmix64(splitmix64(seed) ^ pair) >> 11) * 0x1p-53;
}

} // namespace

Dendrogram::Dendrogram(const LightSet& lights, const BuildConfig& config)
    : lights_(lights), config_(config) {
  const std::size_t total = 2 * lights.size() - 1;
  nodes_.reserve(total);
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Box box{lights[i].position, lights[i].position};
    nodes_.push_back({box, glm::dvec3(lights[i].intensity), 0, i, 1, only(lights[i].kind)});
  }
  children_.resize(total);
}

std::vector<Cluster> Dendrogram::clusters_of(LightKind kind) const {
  Box all = Box::empty();
  for (const Light& light : lights_)
    if (light.kind == kind) all.extend(light.position);
  const double diagonal = std::sqrt(squared_diagonal_of_union(all, all));
  const auto axis_scale = static_cast<float>(0.25 * std::sqrt(diagonal));
  std::vector<Cluster> clusters;
  for (std::uint32_t i = 0; i < lights_.size(); ++i) {
    if (lights_[i].kind != kind) continue;
    const glm::vec3 axis = axis_scale * lights_[i].axis;
    clusters.push_back({nodes_[i].box, {axis, axis}, sum_of_channels(nodes_[i].intensity), i, i});
  }
  return clusters;
}

Cluster Dendrogram::join(Cluster a, Cluster b) {
  constexpr std::size_t now_and_then = 1024;
  if (nodes_.size() % now_and_then == 0) leave_if_cancelled();
  if (b.id < a.id) std::swap(a, b);
  const TreeNode& node_a = nodes_[a.node];
  const TreeNode& node_b = nodes_[b.node];
  Box box = a.box, axes = a.axes;
  box.extend(b.box);
  axes.extend(b.axes);
  const auto merged = static_cast<std::uint32_t>(nodes_.size());
  children_[merged] = {a.node, b.node};
  nodes_.push_back({box, node_a.intensity + node_b.intensity, 0,
                    (takes_first(a, b) ? node_a : node_b).representative,
                    node_a.light_count + node_b.light_count, node_a.kinds | node_b.kinds});
  return {box, axes, a.weight + b.weight, a.id, merged};
}

bool Dendrogram::takes_first(const Cluster& a, const Cluster& b) const {
  return hashed_uniform(config_.seed, a.id, b.id) * (a.weight + b.weight) < a.weight;
}

std::vector<TreeNode> Dendrogram::laid_out() const {
  std::vector<TreeNode> result;
  result.reserve(nodes_.size());
  result.push_back(nodes_.back());
  std::vector<Children> open{{static_cast<std::uint32_t>(nodes_.size() - 1), 0}};
  while (!open.empty()) {
    const auto [cluster, place] = open.back();
    open.pop_back();
    if (nodes_[cluster].light_count == 1) continue;
    const auto [a, b] = children_[cluster];
    const auto first = static_cast<std::uint32_t>(result.size());
    result[place].first_child = first;
    result.push_back(nodes_[a]);
    result.push_back(nodes_[b]);
    open.emplace_back(b, first + 1);
    open.emplace_back(a, first);
  }
  return result;
}

} // namespace lightcuts
