// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// Probabilities with which the descent from a cluster goes to its two children. Both 0 where
/// neither can contribute; else they sum to 1, and a child has 0 only if it cannot contribute.
struct ChildShares {
  double first = 0, second = 0;
};

/// The least share of a child that can contribute: weights say little of what is so dim, and no
/// rounding makes it 0.
inline constexpr double min_share = 0x1p-20;

/// Shares in proportion to two weights >= 0 with a finite sum, but for min_share; weight 0: cannot
/// contribute.
[[nodiscard]] inline ChildShares shares_of(double first, double second) {
  if (second == 0) return {first > 0 ? 1.0 : 0.0, 0};
  if (first == 0) return {0, 1};
  const double share = std::clamp(first / (first + second), min_share, 1 - min_share);
  return {share, 1 - share};
}

/// Children in proportion to their intensity, summed over the channels, wherever the point is.
struct IntensityImportance {
  [[nodiscard]] static ChildShares shares(const LightTree& tree, std::uint32_t node,
                                          const ShadingPoint& /*point*/) {
    const auto weight = [&](std::uint32_t i) {
      const glm::dvec3& intensity = tree.node(i).intensity;
      return intensity.x + intensity.y + intensity.z;
    };
    const std::uint32_t first = tree.node(node).first_child;
    return shares_of(weight(first), weight(first + 1));
  }
};

/// Hierarchical importance sampling of Yuksel (2019, "Stochastic Lightcuts"):
///   w_0/d_0^2 : w_1/d_1^2 ,
/// w being the upper bound of intensity x material x n.l x emission over the child's box, summed
/// over the channels, and d the least distance to that box (at least LightSet::min_distance()).
/// Without the distances where a d is at most the diagonal of its box: the light drawn may then be
/// much farther than that. Directional lights have no distance. The children of a mixed cluster
/// differ in kind, so that theirs have to stay: w / max(d, diagonal)^2, summed over the kinds.
struct HierarchicalImportance {
  [[nodiscard]] static ChildShares shares(const LightTree& tree, std::uint32_t node,
                                          const ShadingPoint& point);
};

/// The shares of an importance at one point, the same bits: those that were asked for last are not
/// computed again. One per thread.
template <class Importance>
class SharesAtPoint {
public:
  /// The point and the tree are those of the first call since forget().
  [[nodiscard]] ChildShares shares(const LightTree& tree, std::uint32_t node,
                                   const ShadingPoint& point) const {
    Slot& slot = slots_[node % slots_.size()];
    if (!slot.known || slot.node != node)
      slot = {Importance::shares(tree, node, point), node, true};
    return slot.shares;
  }
  /// Before another point or tree.
  void forget() { slots_.fill({}); }

private:
  struct Slot {
    ChildShares shares;
    std::uint32_t node = 0;
    bool known = false;
  };
  mutable std::array<Slot, 64> slots_{};
};

/// A light drawn from a cluster; probability 0: none, as nothing that was come to can contribute.
struct LightSample {
  std::uint32_t light = 0; ///< index into the LightSet
  double probability = 0;
};

/// Draws a light of the cluster by descending from it, u uniform in [0, 1) and rescaled at every
/// level. Every light that can contribute has a probability above 0, but for one below 2^-1074, for
/// which it takes more than 50 levels. Each light is drawn for one interval of u, whose length is
/// its probability to within 2^-52 per level; those of all lights, and of none, cover [0, 1).
template <class Importance>
[[nodiscard]] LightSample sample_light(const Importance& importance, const LightTree& tree,
                                       std::uint32_t node, const ShadingPoint& point, double u) {
  constexpr double below_1 = 1 - 0x1p-53;
  double probability = 1;
  while (!tree.node(node).is_leaf()) {
    const ChildShares share = importance.shares(tree, node, point);
    if (share.first == 0 && share.second == 0) return {};
    node = tree.node(node).first_child;
    if (u < share.first) {
      u /= share.first;
      probability *= share.first;
    } else {
      // Both differences may round, and then to the same number.
      u = std::min((u - share.first) / share.second, below_1);
      probability *= share.second;
      ++node;
    }
  }
  return {tree.node(node).representative, probability};
}

/// Calls visit(light, probability) for each light of the cluster, with the probability that
/// sample_light() has for it, bit for bit.
template <class Importance, class Visit>
void visit_probabilities(const Importance& importance, const LightTree& tree, std::uint32_t node,
                         const ShadingPoint& point, Visit&& visit, double probability = 1) {
  const TreeNode& cluster = tree.node(node);
  if (cluster.is_leaf()) {
    visit(cluster.representative, probability);
    return;
  }
  ChildShares share;
  if (probability > 0) share = importance.shares(tree, node, point);
  visit_probabilities(importance, tree, cluster.first_child, point, visit,
                      probability * share.first);
  visit_probabilities(importance, tree, cluster.first_child + 1, point, visit,
                      probability * share.second);
}

/// Probability with which sample_light() draws the light from the cluster, bit for bit; 0 where it
/// is none of the cluster's. Takes time proportional to the cluster's lights.
template <class Importance>
[[nodiscard]] double light_probability(const Importance& importance, const LightTree& tree,
                                       std::uint32_t node, std::uint32_t light,
                                       const ShadingPoint& point) {
  double result = 0;
  visit_probabilities(importance, tree, node, point, [&](std::uint32_t i, double probability) {
    if (i == light) result = probability;
  });
  return result;
}

} // namespace lightcuts
