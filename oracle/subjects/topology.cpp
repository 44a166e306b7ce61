// SPDX-License-Identifier: MIT
#include <oracle/subjects/topology.h>

#include <utility>

#include <fmt/format.h>

namespace lightcuts::oracle {
namespace {

bool fits(std::uint32_t first, std::uint32_t count, std::size_t size) {
  return std::uint64_t(first) + count <= size;
}

/// What makes the claim no tree at all, or nothing.
std::string structural_defect(const TreeClaim& claim, std::size_t light_count) {
  const std::size_t nodes = claim.nodes.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    const TreeClaim::Node& n = claim.nodes[i];
    if (!fits(n.first_child, n.child_count, claim.children.size()))
      return fmt::format("node {} has children beyond the list of children", i);
    if (n.child_count == 0 && !fits(n.first_light, n.light_count, claim.lights.size()))
      return fmt::format("node {} has lights beyond the list of lights", i);
    if (n.representative != TreeClaim::unsaid && n.representative >= light_count)
      return fmt::format("node {} has light {} of {} as its representative", i, n.representative,
                         light_count);
    for (std::uint32_t k = 0; k < n.child_count; ++k)
      if (claim.children[n.first_child + k] >= nodes)
        return fmt::format("node {} has node {} of {} as a child", i,
                           claim.children[n.first_child + k], nodes);
    for (std::uint32_t k = 0; n.child_count == 0 && k < n.light_count; ++k)
      if (claim.lights[n.first_light + k] >= light_count)
        return fmt::format("node {} has light {} of {}", i, claim.lights[n.first_light + k],
                           light_count);
  }
  return {};
}

} // namespace

void Topology::sort_lights() {
  first_.resize(size());
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    first_[i] = std::uint32_t(lights_.size());
    lights_.insert(lights_.end(), lights(i).begin(), lights(i).end());
    open.insert(open.end(), children(i).begin(), children(i).end());
  }
}

TopologyReading read_topology(TreeClaim claim, std::size_t light_count) {
  if (std::string defect = structural_defect(claim, light_count); !defect.empty())
    return {std::nullopt, std::move(defect)};
  if (claim.nodes.empty()) {
    if (light_count == 0) return {Topology(), {}};
    return {std::nullopt, fmt::format("no node for {} lights", light_count)};
  }
  Topology t;
  t.claim_ = std::move(claim);
  std::vector<bool> reached(t.size(), false);
  reached[0] = true;
  t.order_.push_back(0);
  for (std::size_t at = 0; at < t.order_.size(); ++at)
    for (const std::uint32_t child : t.children(t.order_[at])) {
      if (reached[child])
        return {std::nullopt, child == 0
                                  ? fmt::format("the root is a child of node {}", t.order_[at])
                                  : fmt::format("node {} is a child twice, of node {} at last",
                                                child, t.order_[at])};
      reached[child] = true;
      t.order_.push_back(child);
    }
  for (std::uint32_t i = 0; i < t.size(); ++i)
    if (!reached[i]) return {std::nullopt, fmt::format("node {} is nobody's child", i)};

  std::vector<unsigned> seen(light_count, 0);
  t.counts_.resize(t.size());
  for (auto i = t.order_.rbegin(); i != t.order_.rend(); ++i) {
    t.counts_[*i] = std::uint32_t(t.lights(*i).size());
    for (const std::uint32_t child : t.children(*i)) t.counts_[*i] += t.counts_[child];
    for (const std::uint32_t light : t.lights(*i)) ++seen[light];
  }
  t.sort_lights();
  std::string defect;
  for (std::size_t light = 0; light < light_count && defect.empty(); ++light)
    if (seen[light] != 1) defect = fmt::format("light {} is in {} leaves", light, seen[light]);
  return {std::move(t), std::move(defect)};
}

} // namespace lightcuts::oracle
