// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <lightcuts/core/tree/cluster.h>

namespace lightcuts {

/// A cluster's cheapest partner; the lowest id among equals.
struct Neighbour {
  double cost = std::numeric_limits<double>::infinity();
  std::uint32_t id = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t slot = 0;
};

/// k-d tree over clusters that finds cheapest partners exactly while clusters merge. A cluster
/// lives in a slot; neighbouring slots are near in space. Build it anew once most clusters have
/// gone.
class ClusterIndex {
public:
  explicit ClusterIndex(std::vector<Cluster> clusters);

  [[nodiscard]] std::uint32_t slot_count() const {
    return static_cast<std::uint32_t>(slots_.size());
  }
  [[nodiscard]] bool holds_cluster(std::uint32_t slot) const { return slots_[slot].id != gone; }
  [[nodiscard]] const Cluster& at(std::uint32_t slot) const { return slots_[slot]; }

  /// The cheapest partner of the cluster in the slot; cost inf if it is the only one.
  [[nodiscard]] Neighbour nearest(std::uint32_t slot) const;

  /// Puts `merged` in slot a and empties slot b.
  void replace(std::uint32_t a, std::uint32_t b, const Cluster& merged);

  /// The clusters that are left, in the order of slots.
  [[nodiscard]] std::vector<Cluster> clusters() const;

private:
  struct Node {
    Box box, axes;
    double min_weight;
    std::uint32_t min_id;
  };
  static constexpr std::uint32_t leaf_size = 4;
  static constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();

  void split(std::uint32_t node, std::span<Cluster> members, std::uint32_t first_leaf);
  void update_from(std::uint32_t leaf);
  void summarise(std::uint32_t node);
  void scan_leaf(std::uint32_t leaf, std::uint32_t self, Neighbour& best) const;
  void search(std::uint32_t node, std::uint32_t self, Neighbour& best) const;
  void search_if_better(std::uint32_t node, double cost, std::uint32_t self, Neighbour& best) const;
  [[nodiscard]] double least_cost(std::uint32_t node, const Cluster& of) const;
  [[nodiscard]] std::uint32_t leaf_of(std::uint32_t slot) const {
    return leaves_ + slot / leaf_size;
  }

  std::uint32_t leaves_;       ///< a power of two; nodes_[leaves_ + i] is leaf i, [1] the root
  std::vector<Node> nodes_;    ///< children of i: 2i and 2i + 1
  std::vector<Cluster> slots_; ///< leaf_size per leaf; id is `gone` where empty
};

} // namespace lightcuts
