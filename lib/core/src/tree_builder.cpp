// SPDX-License-Identifier: MIT
#include <lightcuts/tree_builder.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cluster_index.h"
#include <lightcuts/input_error.h>
#include <lightcuts/splitmix.h>

namespace lightcuts {
namespace {

using Children = std::pair<std::uint32_t, std::uint32_t>;

double sum_of_channels(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// Uniform in [0, 1), the same for the same arguments.
double hashed_uniform(std::uint64_t seed, std::uint32_t a, std::uint32_t b) {
  const std::uint64_t pair = (std::uint64_t(a) << 32) | b;
  return double(splitmix64(splitmix64(seed) ^ pair) >> 11) * 0x1p-53;
}

/// Greedy clustering by nearest-neighbour chains: from any cluster follow cheapest partners until
/// two are each other's, and merge those. Costs never fall when clusters merge, and pairs are
/// ordered strictly (cost, then ids), so this makes the same merges as taking the cheapest pair of
/// all each time, in another order (Murtagh 1983; Walter et al. 2008, section 3.2).
class Clustering {
public:
  Clustering(const LightSet& lights, std::uint64_t seed) : lights_(lights), seed_(seed) {
    const std::size_t total = 2 * lights.size() - 1;
    nodes_.reserve(total);
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      const Box box{lights[i].position, lights[i].position};
      nodes_.push_back({box, glm::dvec3(lights[i].intensity), 0, i, 1, only(lights[i].kind)});
    }
    children_.resize(total);
  }

  /// Merges until one cluster is left: the lights of each kind among themselves, then those.
  void run() {
    std::vector<Cluster> roots;
    for (int kind = 0; kind < light_kind_count; ++kind)
      if (std::vector<Cluster> lights = clusters_of(LightKind(kind)); !lights.empty())
        roots.push_back(merged_to_one(std::move(lights)));
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    Cluster all = roots.front();
    for (std::size_t i = 1; i < roots.size(); ++i) all = joined(all, roots[i]);
  }

  /// The tree as LightTree wants it: node 0 the root, siblings together, parents before children.
  [[nodiscard]] std::vector<TreeNode> laid_out() const {
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

private:
  [[nodiscard]] std::vector<Cluster> clusters_of(LightKind kind) const {
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

  Cluster merged_to_one(std::vector<Cluster> left) {
    while (left.size() > 1) {
      ClusterIndex index(std::move(left));
      merge_half(index);
      left = index.clusters();
    }
    return left.front();
  }

  /// Merges until half of the index's clusters have gone.
  void merge_half(ClusterIndex& index) {
    const std::size_t clusters = index.clusters().size();
    std::size_t merges = clusters - std::max<std::size_t>(clusters / 2, 1);
    std::vector<std::uint32_t> chain;
    for (std::uint32_t start = 0; merges > 0;) {
      if (chain.empty()) {
        while (!index.holds_cluster(start)) start = (start + 1) % index.slot_count();
        chain.push_back(start);
      }
      const std::uint32_t partner = index.nearest(chain.back()).slot;
      if (chain.size() < 2 || partner != chain[chain.size() - 2]) {
        chain.push_back(partner);
        continue;
      }
      merge(index, chain.back(), partner);
      chain.resize(chain.size() - 2);
      --merges;
    }
  }

  void merge(ClusterIndex& index, std::uint32_t slot_a, std::uint32_t slot_b) {
    if (index.at(slot_b).id < index.at(slot_a).id) std::swap(slot_a, slot_b);
    index.replace(slot_a, slot_b, joined(index.at(slot_a), index.at(slot_b)));
  }

  /// Makes a node of the two; a has the lower id.
  Cluster joined(const Cluster& a, const Cluster& b) {
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

  [[nodiscard]] bool takes_first(const Cluster& a, const Cluster& b) const {
    return hashed_uniform(seed_, a.id, b.id) * (a.weight + b.weight) < a.weight;
  }

  const LightSet& lights_;
  std::uint64_t seed_;
  std::vector<TreeNode> nodes_; ///< the lights, then the merged clusters
  std::vector<Children> children_;
};

} // namespace

LightTree build(const LightSet& lights, const BuildConfig& config) {
  if (lights.empty()) return {};
  if (lights.size() > (std::size_t(1) << 31))
    throw InputError("more than 2^31 lights: a tree node's index has 32 bits");
  Clustering clustering(lights, config.seed);
  clustering.run();
  return {lights, clustering.laid_out()};
}

} // namespace lightcuts
