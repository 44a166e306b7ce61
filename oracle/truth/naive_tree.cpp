// SPDX-License-Identifier: MIT
#include <oracle/truth/naive_tree.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace lightcuts::oracle {
namespace {

std::vector<NaiveCluster> leaves_of(const LightSet& lights) {
  std::vector<NaiveCluster> leaves;
  Box all = Box::empty();
  for (const Light& light : lights) all.extend(light.position);
  const double diagonal = std::sqrt(squared_diagonal_of_union(all, all));
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const glm::dvec3 power(lights[i].intensity);
    const glm::vec3 axis = float(std::sqrt(diagonal) / 4) * lights[i].axis;
    leaves.push_back({.box = {lights[i].position, lights[i].position},
                      .axes = {axis, axis},
                      .intensity = power,
                      .weight = power.x + power.y + power.z,
                      .first = i,
                      .representative = i,
                      .representative_weight = power.x + power.y + power.z});
  }
  return leaves;
}

NaiveCluster merged(const NaiveCluster& a, const NaiveCluster& b) {
  NaiveCluster m = a;
  m.box.extend(b.box);
  m.axes.extend(b.axes);
  m.intensity += b.intensity;
  m.weight += b.weight;
  m.light_count += b.light_count;
  return m;
}

std::int32_t merge(std::vector<NaiveCluster>& all, std::int32_t a, std::int32_t b) {
  NaiveCluster m = merged(all[std::size_t(a)], all[std::size_t(b)]);
  m.children[0] = a;
  m.children[1] = b;
  all.push_back(m);
  return std::int32_t(all.size() - 1);
}

std::int32_t merge_halves(std::vector<NaiveCluster>& all, std::span<const std::int32_t> group) {
  if (group.size() == 1) return group[0];
  const std::size_t half = group.size() - group.size() / 2;
  const std::int32_t first = merge_halves(all, group.first(half));
  return merge(all, first, merge_halves(all, group.subspan(half)));
}

/// One cluster for all lights of one place and axis, in the order of their lowest lights.
std::vector<std::int32_t> merge_equals(std::vector<NaiveCluster>& all) {
  const auto lights = std::int32_t(all.size());
  const auto same = [&](std::int32_t i, std::int32_t j) {
    const NaiveCluster &a = all[std::size_t(i)], &b = all[std::size_t(j)];
    return a.box == b.box && a.axes == b.axes;
  };
  std::vector<std::int32_t> merged;
  std::vector<char> taken(all.size(), 0);
  for (std::int32_t i = 0; i < lights; ++i) {
    if (taken[std::size_t(i)] != 0) continue;
    std::vector<std::int32_t> group;
    for (std::int32_t j = i; j < lights; ++j) {
      if (!same(i, j)) continue;
      taken[std::size_t(j)] = 1;
      group.push_back(j);
    }
    merged.push_back(merge_halves(all, group));
  }
  return merged;
}

} // namespace

double greedy_metric(const NaiveCluster& a, const NaiveCluster& b) {
  const double spread = squared_diagonal_of_union(a.axes, b.axes);
  return (a.weight + b.weight) * (squared_diagonal_of_union(a.box, b.box) + spread * spread);
}

std::vector<NaiveCluster> naive_clusters(const LightSet& lights, const Metric& metric) {
  std::vector<NaiveCluster> all = leaves_of(lights);
  std::vector<std::int32_t> open = merge_equals(all); // in the order of their lowest lights
  const auto at = [&](std::size_t i) -> const NaiveCluster& { return all[std::size_t(open[i])]; };
  while (open.size() > 1) {
    std::size_t a = 0, b = 1;
    double least = metric(at(0), at(1));
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::size_t j = i + 1; j < open.size(); ++j)
        if (const double cost = metric(at(i), at(j)); cost < least) {
          least = cost;
          a = i;
          b = j;
        }
    open[a] = merge(all, open[a], open[b]);
    open.erase(open.begin() + std::ptrdiff_t(b));
  }
  return all;
}

LightTree naive_tree(const LightSet& lights, const Metric& metric) {
  const std::vector<NaiveCluster> clusters = naive_clusters(lights, metric);
  std::vector<TreeNode> nodes;
  std::vector<std::pair<std::int32_t, std::size_t>> open;
  const auto place = [&](std::int32_t cluster) {
    const NaiveCluster& c = clusters[std::size_t(cluster)];
    nodes.push_back({c.box, c.intensity, 0, c.representative, c.light_count, lights.kinds()});
    open.emplace_back(cluster, nodes.size() - 1);
  };
  if (!clusters.empty()) place(std::int32_t(clusters.size() - 1));
  while (!open.empty()) {
    const auto [cluster, node] = open.back();
    open.pop_back();
    const NaiveCluster& c = clusters[std::size_t(cluster)];
    if (c.children[0] < 0) continue;
    nodes[node].first_child = std::uint32_t(nodes.size());
    place(c.children[0]);
    place(c.children[1]);
  }
  return {lights, std::move(nodes)};
}

double naive_tree_cost(const LightSet& lights) {
  double sum = 0;
  const std::vector<NaiveCluster> all = naive_clusters(lights);
  for (const NaiveCluster& c : all)
    if (c.children[0] >= 0)
      sum += greedy_metric(all[std::size_t(c.children[0])], all[std::size_t(c.children[1])]);
  return sum;
}

double tree_cost(const Topology& topology, const LightSet& lights) {
  const std::vector<NaiveCluster> leaves = leaves_of(lights);
  double sum = 0;
  for (std::uint32_t node = 0; node < topology.size(); ++node) {
    const std::span<const std::uint32_t> members = topology.all_lights(node);
    if (members.size() < 2) continue;
    NaiveCluster c = leaves[members.front()];
    for (std::size_t i = 1; i + 1 < members.size(); ++i) c = merged(c, leaves[members[i]]);
    sum += greedy_metric(c, leaves[members.back()]);
  }
  return sum;
}

} // namespace lightcuts::oracle
