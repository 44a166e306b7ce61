// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/light_sampling.h>

#include <lightcuts/core/geometry/box_bounds.h>

namespace lightcuts {
namespace {

double squared_diagonal(const Box& box) { return squared_diagonal_of_union(box, box); }

/// cosine_bound() over the channels. What exceeds the largest float counts as that.
double weight(const LightTree& tree, std::uint32_t i, const ShadingPoint& point) {
  constexpr float largest = std::numeric_limits<float>::max();
  const glm::vec3 w = cosine_bound(tree, i, point);
  return double(std::min(w.x, largest)) + std::min(w.y, largest) + std::min(w.z, largest);
}

double mixed_weight(const LightTree& tree, std::uint32_t i, const ShadingPoint& point) {
  const TreeNode& cluster = tree.node(i);
  if (cluster.is_mixed())
    return mixed_weight(tree, cluster.first_child, point) +
           mixed_weight(tree, cluster.first_child + 1, point);
  const double w = weight(tree, i, point);
  if (w == 0 || is_at_infinity(cluster.kind())) return w;
  return w / std::max({min_distance2(point.position(), cluster.box), squared_diagonal(cluster.box),
                       tree.min_distance2()});
}

} // namespace

ChildShares HierarchicalImportance::shares(const LightTree& tree, std::uint32_t node,
                                           const ShadingPoint& point) {
  const std::uint32_t first = tree.node(node).first_child;
  if (tree.node(node).is_mixed()) [[unlikely]]
    return shares_of(mixed_weight(tree, first, point), mixed_weight(tree, first + 1, point));
  const double w0 = weight(tree, first, point), w1 = weight(tree, first + 1, point);
  if (w0 == 0 || w1 == 0 || is_at_infinity(tree.node(node).kind())) return shares_of(w0, w1);
  const Box &box0 = tree.node(first).box, &box1 = tree.node(first + 1).box;
  const double d0 = min_distance2(point.position(), box0);
  const double d1 = min_distance2(point.position(), box1);
  if (d0 <= squared_diagonal(box0) || d1 <= squared_diagonal(box1)) return shares_of(w0, w1);
  const double least = tree.min_distance2();
  return shares_of(w0 / std::max(d0, least), w1 / std::max(d1, least));
}

} // namespace lightcuts
