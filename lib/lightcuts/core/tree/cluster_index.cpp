// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_index.h>

#include <algorithm>
#include <bit>

namespace lightcuts {
namespace {

int widest_axis(const Box& box) {
  const glm::dvec3 extent = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

double centre2(const Cluster& c, int axis) { return double(c.box.lo[axis]) + c.box.hi[axis]; }

} // namespace

ClusterIndex::ClusterIndex(std::vector<Cluster> clusters)
    : leaves_(
          std::bit_ceil(static_cast<std::uint32_t>(clusters.size() + leaf_size - 1) / leaf_size)),
      nodes_(2 * std::size_t(leaves_)),
      slots_(std::size_t(leaves_) * leaf_size, Cluster{Box::empty(), Box::empty(), 0, gone, 0}) {
  split(1, clusters, 0);
  for (std::uint32_t i = 2 * leaves_ - 1; i >= 1; --i) summarise(i);
}

void ClusterIndex::split(std::uint32_t node, std::span<Cluster> members, std::uint32_t first_leaf) {
  if (node >= leaves_) {
    std::copy(members.begin(), members.end(),
              slots_.begin() + static_cast<std::ptrdiff_t>(first_leaf) * leaf_size);
    return;
  }
  Box box = Box::empty();
  for (const Cluster& m : members) box.extend(m.box);
  const int axis = widest_axis(box);
  const std::size_t half = members.size() / 2;
  std::nth_element(
      members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
      [&](const Cluster& a, const Cluster& b) { return centre2(a, axis) < centre2(b, axis); });
  const auto level = static_cast<std::uint32_t>(std::bit_width(node)) - 1;
  const std::uint32_t leaves_below = leaves_ >> level;
  split(2 * node, members.first(half), first_leaf);
  split(2 * node + 1, members.subspan(half), first_leaf + leaves_below / 2);
}

void ClusterIndex::summarise(std::uint32_t node) {
  Node sum{Box::empty(), Box::empty(), std::numeric_limits<double>::infinity(), gone};
  const auto add = [&sum](const Box& box, const Box& axes, double weight, std::uint32_t id) {
    sum.box.extend(box);
    sum.axes.extend(axes);
    sum.min_weight = std::min(sum.min_weight, weight);
    sum.min_id = std::min(sum.min_id, id);
  };
  if (node < leaves_) {
    for (const auto child : {2 * node, 2 * node + 1})
      add(nodes_[child].box, nodes_[child].axes, nodes_[child].min_weight, nodes_[child].min_id);
  } else {
    const std::uint32_t first = (node - leaves_) * leaf_size;
    for (std::uint32_t slot = first; slot < first + leaf_size; ++slot)
      if (holds_cluster(slot))
        add(slots_[slot].box, slots_[slot].axes, slots_[slot].weight, slots_[slot].id);
  }
  nodes_[node] = sum;
}

void ClusterIndex::update_from(std::uint32_t leaf) {
  for (std::uint32_t node = leaf; node >= 1; node /= 2) summarise(node);
}

void ClusterIndex::replace(std::uint32_t a, std::uint32_t b, const Cluster& merged) {
  slots_[a] = merged;
  slots_[b].id = gone;
  update_from(leaf_of(b));
  update_from(leaf_of(a));
}

double ClusterIndex::least_cost(std::uint32_t node, const Cluster& of) const {
  const Node& n = nodes_[node];
  // A cluster below the node reaches at least from hi down and from lo up.
  const auto least = [](const Box& below, const Box& own) {
    const Box nearest{glm::min(below.hi, own.lo), glm::max(below.lo, own.hi)};
    return squared_diagonal_of_union(nearest, nearest);
  };
  const double spread = least(n.axes, of.axes);
  return (of.weight + n.min_weight) * (least(n.box, of.box) + spread * spread);
}

void ClusterIndex::scan_leaf(std::uint32_t leaf, std::uint32_t self, Neighbour& best) const {
  const std::uint32_t first = (leaf - leaves_) * leaf_size;
  for (std::uint32_t slot = first; slot < first + leaf_size; ++slot) {
    if (slot == self || !holds_cluster(slot)) continue;
    const double cost = union_cost(slots_[self], slots_[slot]);
    const std::uint32_t id = slots_[slot].id;
    if (cost < best.cost || (cost == best.cost && id < best.id)) best = {cost, id, slot};
  }
}

void ClusterIndex::search_if_better(std::uint32_t node, double cost, std::uint32_t self,
                                    Neighbour& best) const {
  const std::uint32_t min_id = nodes_[node].min_id;
  if (min_id == gone || cost > best.cost || (cost == best.cost && min_id >= best.id)) return;
  search(node, self, best);
}

void ClusterIndex::search(std::uint32_t node, std::uint32_t self, Neighbour& best) const {
  if (node >= leaves_) {
    scan_leaf(node, self, best);
    return;
  }
  const double cost[2] = {least_cost(2 * node, slots_[self]),
                          least_cost(2 * node + 1, slots_[self])};
  // Of equals the one that may hold the lower id, which then rules the other one out.
  const bool is_second_better = cost[0] == cost[1]
                                    ? nodes_[2 * node + 1].min_id < nodes_[2 * node].min_id
                                    : cost[1] < cost[0];
  const std::uint32_t first = is_second_better ? 1 : 0;
  search_if_better(2 * node + first, cost[first], self, best);
  search_if_better(2 * node + 1 - first, cost[1 - first], self, best);
}

Neighbour ClusterIndex::nearest(std::uint32_t slot) const {
  Neighbour best;
  std::uint32_t node = leaf_of(slot);
  scan_leaf(node, slot, best);
  for (; node > 1; node /= 2)
    search_if_better(node ^ 1U, least_cost(node ^ 1U, slots_[slot]), slot, best);
  return best;
}

std::vector<Cluster> ClusterIndex::clusters() const {
  std::vector<Cluster> result;
  std::copy_if(slots_.begin(), slots_.end(), std::back_inserter(result),
               [](const Cluster& c) { return c.id != gone; });
  return result;
}

} // namespace lightcuts
