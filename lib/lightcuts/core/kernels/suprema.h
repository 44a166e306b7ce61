// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/kinds/light_kinds.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// The suprema over the box of a cluster that its bound is a product of; see cluster_bound(). Of
/// one kind of light: n.l and the falloff in one, as tight as the box allows.
template <class Kind>
struct JointSuprema {
  static constexpr LightKind kind_of(const TreeNode& /*cluster*/) { return Kind::kind; }

  /// The supremum of n.l falloff over q, n about unit, times the length of n.
  static double max_cosine_falloff(const glm::vec3& n, const DifferenceBox& q,
                                   double min_distance2) {
    if (is_at_infinity(Kind::kind)) return max_cosine(n, q);
    const double joint = max_cosine_over_distance2(n, q);
    // The clamped one is the smaller of two, and so is its supremum at most: the first of them
    // where no distance is clamped.
    if (min_distance2 > 0 && joint > 0 && min_length2(q) < min_distance2) [[unlikely]]
      return std::min(joint, max_cosine(n, q) / min_distance2);
    return joint;
  }
  static double max_cosine_falloff(LightKind /*kind*/, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double min_distance2) {
    return max_cosine_falloff(n, DifferenceBox(from, box), min_distance2);
  }

  /// The supremum of the falloff over q.
  static double max_falloff(const DifferenceBox& q, double min_distance2) {
    return is_at_infinity(Kind::kind) ? 1 : 1 / std::max(min_length2(q), min_distance2);
  }
  static double max_falloff(LightKind /*kind*/, const glm::vec3& from, const Box& box,
                            double min_distance2) {
    return max_falloff(DifferenceBox(from, box), min_distance2);
  }

  /// The supremum of emission() towards `from` of the lights of node i.
  static double max_emission(const LightTree& tree, std::uint32_t i, LightKind /*kind*/,
                             const glm::vec3& from) {
    return Kind::max_emission(tree.emission(i), DifferenceBox(from, tree.node(i).box));
  }
};

/// Separate maxima of n.l and the falloff, as the paper has it: looser.
template <class Kind>
struct ProductSuprema : JointSuprema<Kind> {
  static double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double min_distance2) {
    const double cosine = max_cosine(n, from, box);
    return cosine == 0 ? 0
                       : cosine * JointSuprema<Kind>::max_falloff(kind, from, box, min_distance2);
  }
};

/// Material, cosine and emission alone, whatever the distance.
template <class Kind>
struct CosineSuprema : JointSuprema<Kind> {
  static double max_cosine_falloff(LightKind /*kind*/, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double /*min_distance2*/) {
    return max_cosine(n, from, box);
  }
  static double max_falloff(LightKind /*kind*/, const glm::vec3& /*from*/, const Box& /*box*/,
                            double /*min_distance2*/) {
    return 1;
  }
};

} // namespace lightcuts
