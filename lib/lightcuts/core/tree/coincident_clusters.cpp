// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/coincident_clusters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

namespace lightcuts {
namespace {

/// Where a cluster is; sorts those at one place together, in their order.
struct Place {
  glm::vec3 position;
  std::uint32_t index; ///< of the cluster
};

using Order = std::vector<Place>;

auto axis_key(const Cluster& c) { return std::tuple(c.axes.lo.x, c.axes.lo.y, c.axes.lo.z); }

Order sorted(std::span<const Cluster> clusters) {
  Order order;
  order.reserve(clusters.size());
  for (std::uint32_t i = 0; i < clusters.size(); ++i) order.push_back({clusters[i].box.lo, i});
  std::sort(order.begin(), order.end(), [&](const Place& a, const Place& b) {
    const auto at = [](const Place& p) {
      return std::tie(p.position.x, p.position.y, p.position.z);
    };
    if (at(a) != at(b)) return at(a) < at(b);
    const auto axis_a = axis_key(clusters[a.index]), axis_b = axis_key(clusters[b.index]);
    return axis_a != axis_b ? axis_a < axis_b : a.index < b.index;
  });
  return order;
}

Cluster merged_in_halves(std::span<const Cluster> clusters, std::span<const Place> group,
                         Dendrogram& record) {
  if (group.size() == 1) return clusters[group.front().index];
  const std::size_t half = (group.size() + 1) / 2;
  const Cluster first = merged_in_halves(clusters, group.first(half), record);
  return record.join(first, merged_in_halves(clusters, group.subspan(half), record));
}

} // namespace

std::vector<Cluster> merge_coincident(std::vector<Cluster> clusters, Dendrogram& record) {
  const Order order = sorted(clusters);
  record.leave_if_cancelled();
  std::vector<Cluster> result;
  result.reserve(clusters.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Cluster& first = clusters[order[begin].index];
    while (end < order.size() && order[end].position == order[begin].position &&
           axis_key(clusters[order[end].index]) == axis_key(first))
      ++end;
    result.push_back(
        merged_in_halves(clusters, std::span(order).subspan(begin, end - begin), record));
  }
  if (result.size() == clusters.size()) return clusters;
  std::sort(result.begin(), result.end(),
            [](const Cluster& a, const Cluster& b) { return a.id < b.id; });
  return result;
}

} // namespace lightcuts
