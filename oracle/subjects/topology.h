// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lightcuts::oracle {

/// What a subject says its tree is; nothing of it is believed until read_topology() has read it.
struct TreeClaim {
  static constexpr std::uint32_t unsaid = std::numeric_limits<std::uint32_t>::max();

  struct Node {
    std::uint32_t first_child = 0; ///< its children are children[first_child ...]
    std::uint32_t child_count = 0; ///< 0: a leaf
    std::uint32_t first_light = 0; ///< a leaf's lights are lights[first_light ...]
    std::uint32_t light_count = 0;
    std::uint32_t representative = unsaid;    ///< index of a light, or unsaid
    std::optional<glm::dvec3> intensity = {}; ///< total of the cluster's lights, or unsaid
  };
  std::vector<Node> nodes;             ///< node 0 is the root
  std::vector<std::uint32_t> children; ///< indices of nodes
  std::vector<std::uint32_t> lights;   ///< indices of lights
};

/// A rooted tree over lights: every node but the root, 0, has one parent, and all can be reached.
/// Some lights may be in no leaf, or in several.
class Topology {
public:
  Topology() = default;

  [[nodiscard]] std::uint32_t size() const { return std::uint32_t(claim_.nodes.size()); }
  [[nodiscard]] bool is_leaf(std::uint32_t node) const {
    return claim_.nodes[node].child_count == 0;
  }
  [[nodiscard]] std::span<const std::uint32_t> children(std::uint32_t node) const {
    const TreeClaim::Node& n = claim_.nodes[node];
    return std::span(claim_.children).subspan(n.first_child, n.child_count);
  }
  /// Lights of a leaf; none of other nodes.
  [[nodiscard]] std::span<const std::uint32_t> lights(std::uint32_t node) const {
    const TreeClaim::Node& n = claim_.nodes[node];
    if (n.child_count > 0) return {};
    return std::span(claim_.lights).subspan(n.first_light, n.light_count);
  }
  /// A light's index, or TreeClaim::unsaid.
  [[nodiscard]] std::uint32_t representative(std::uint32_t node) const {
    return claim_.nodes[node].representative;
  }
  [[nodiscard]] const std::optional<glm::dvec3>& intensity(std::uint32_t node) const {
    return claim_.nodes[node].intensity;
  }
  /// All nodes, parents before their children.
  [[nodiscard]] std::span<const std::uint32_t> parents_first() const { return order_; }
  /// Lights of all leaves below the node, with repetition.
  [[nodiscard]] std::span<const std::uint32_t> all_lights(std::uint32_t node) const {
    return std::span(lights_).subspan(first_[node], counts_[node]);
  }
  [[nodiscard]] std::uint32_t light_count(std::uint32_t node) const { return counts_[node]; }

private:
  friend struct TopologyReading read_topology(TreeClaim claim, std::size_t light_count);

  /// Sorts the lights by leaf, so that those of each node lie side by side.
  void sort_lights();

  TreeClaim claim_;
  std::vector<std::uint32_t> order_, counts_;
  std::vector<std::uint32_t> lights_, first_; ///< those of node i begin at lights_[first_[i]]
};

struct TopologyReading {
  std::optional<Topology> topology; ///< nothing where the claim is no tree at all
  std::string defect;               ///< what is wrong with it as a tree over all lights; or nothing
};

/// Makes a tree of what a subject says, looking at every index before it is used.
[[nodiscard]] TopologyReading read_topology(TreeClaim claim, std::size_t light_count);

} // namespace lightcuts::oracle
