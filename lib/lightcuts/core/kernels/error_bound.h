// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/kernels/contribution.h>
#include <lightcuts/core/kernels/features.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/shading/box_sight.h>
#include <lightcuts/core/tree/cluster_emission.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// contribution_bound() is at most (1 + bound_excess) times the real expression it stands for, plus
/// one smallest subnormal float: 2^-23 from the last rounding, the rest before it.
inline constexpr double bound_excess = 0x1p-22;

/// The suprema over a box of one kind of light that bounds are products of. What derives from it
/// may put its own in their place; see bound_by().
template <class TheFeatures>
struct JointSuprema {
  using Features = TheFeatures;

  /// Of n.l falloff, n about unit, times the length of n. Tight: both factors in one.
  static double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double min_distance2) {
    if (Features::known(kind) == LightKind::directional) return max_cosine(n, from, box);
    const double max_cosine_falloff = max_cosine_over_distance2(n, from, box);
    // The clamped one is the smaller of two, and so is its supremum at most: the first of them
    // where no distance is clamped.
    if constexpr (Features::clamps)
      if (max_cosine_falloff > 0 && lightcuts::min_distance2(from, box) < min_distance2)
          [[unlikely]]
        return std::min(max_cosine_falloff, max_cosine(n, from, box) / min_distance2);
    return max_cosine_falloff;
  }

  /// Of the falloff alone.
  static double falloff(LightKind kind, const glm::vec3& from, const Box& box,
                        double min_distance2) {
    if (Features::known(kind) == LightKind::directional) return 1;
    double nearest2 = lightcuts::min_distance2(from, box);
    if constexpr (Features::clamps) nearest2 = std::max(nearest2, min_distance2);
    return 1 / nearest2;
  }

  /// Of emission() of the lights of node i, where they have axes.
  static double emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                         const glm::vec3& from) {
    return max_emission(Features::known(kind), tree.emission(i), from, tree.node(i).box);
  }
};

/// The same with separate maxima of n.l and the falloff, as the paper has it: looser.
template <class Features>
struct ProductSuprema : JointSuprema<Features> {
  static double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                                   const Box& box, double min_distance2) {
    const double cosine = max_cosine(n, from, box);
    return cosine == 0 ? 0
                       : cosine * JointSuprema<Features>::falloff(kind, from, box, min_distance2);
  }
};

namespace detail {

// Makes up for the errors of the box bounds, the lobes, and some roundings.
inline constexpr double bound_inflation = 1 + 0x1p-26;
static_assert(4 * box_bound_error + power_error + 0x1p-48 < 0x1p-26);

/// intensity diffuse/pi geometric, rounded up. Of lights without axes: in floats, the last factor
/// is 0 or above 2^-690, and no product underflows.
inline glm::vec3 diffuse_bound(const glm::dvec3& intensity, const glm::vec3& diffuse,
                               double geometric) {
  const double factor = geometric * std::numbers::inv_pi;
  return {round_up(diffuse.x * factor * intensity.x), round_up(diffuse.y * factor * intensity.y),
          round_up(diffuse.z * factor * intensity.z)};
}

/// intensity emission (diffuse/pi max(n.l falloff) + max(lobe n.l falloff)), rounded up.
template <class Suprema, class OneLobe>
glm::vec3 bound_of_cluster(const Suprema& suprema, const LightTree& tree, std::uint32_t i,
                           const ShadingPoint& point, const OneLobe& lobe) {
  using Features = typename Suprema::Features;
  const TreeNode& cluster = tree.node(i);
  const LightKind kind = Features::known(cluster.kind());
  const glm::vec3 from = viewed_from(kind, point.position());
  const double max_cosine_falloff =
      suprema.max_cosine_falloff(kind, point.normal(), from, cluster.box, tree.min_distance2());
  if (max_cosine_falloff == 0) return glm::vec3(0);
  const double geometric = max_cosine_falloff * point.inverse_normal_length() * bound_inflation;
  if constexpr (std::is_same_v<OneLobe, NoLobe> && !Features::has_axes)
    if (geometric < std::numeric_limits<double>::infinity()) [[likely]]
      return diffuse_bound(cluster.intensity, point.material().diffuse, geometric);
  double emitted = 1;
  if constexpr (Features::has_axes)
    if (Features::uniform || (cluster.kinds & kinds_with_axis) != 0) {
      emitted = suprema.emission(tree, i, kind, from);
      if (emitted == 0) return glm::vec3(0);
    }
  glm::dvec3 shine(0);
  if constexpr (!std::is_same_v<OneLobe, NoLobe>) {
    const double falloff = suprema.falloff(kind, from, cluster.box, tree.min_distance2());
    shine = lobe.bound(BoxSight{point, from, cluster.box, geometric, falloff * bound_inflation});
  }
  glm::vec3 bound;
  for (int c = 0; c < 3; ++c) {
    const double diffuse = point.material().diffuse[c] * std::numbers::inv_pi;
    // 0 * inf is 0 here, and a product of positive numbers is positive.
    const double reflected = (diffuse == 0 ? 0 : diffuse * geometric) + shine[c];
    const double intensity = cluster.intensity[c] * emitted;
    bound[c] = reflected == 0 || intensity == 0
                   ? 0.0F
                   : round_up(std::max(reflected * intensity, 0x1p-1000));
  }
  return bound;
}

/// The sum over children for a mixed cluster, or what one_kind() makes of another.
template <class Features, class OneKind>
glm::dvec3 over_kinds(const LightTree& tree, std::uint32_t i, const OneKind& one_kind) {
  if constexpr (!Features::uniform) {
    const TreeNode& node = tree.node(i);
    if (node.is_mixed()) [[unlikely]]
      return over_kinds<Features>(tree, node.first_child, one_kind) +
             over_kinds<Features>(tree, node.first_child + 1, one_kind);
  }
  return one_kind(i);
}

} // namespace detail

/// Upper bound, per channel, of the cluster's contribution to the radiance seen at the point,
/// whatever is visible, by the given suprema over a box:
///   intensity max(emission) (diffuse/pi max(n.l falloff) + max(lobe n.l falloff)) ,
/// lobe.bound() being the last of them. A mixed cluster: the sum of its children's. Rounded up.
template <class Suprema, class OneLobe>
[[nodiscard]] glm::vec3 bound_by(const Suprema& suprema, const LightTree& tree, std::uint32_t node,
                                 const ShadingPoint& point, const OneLobe& lobe) {
  using Features = typename Suprema::Features;
  if (Features::uniform || !tree.node(node).is_mixed()) [[likely]]
    return detail::bound_of_cluster(suprema, tree, node, point, lobe);
  const glm::dvec3 bound = detail::over_kinds<Features>(tree, node, [&](std::uint32_t i) {
    return glm::dvec3(detail::bound_of_cluster(suprema, tree, i, point, lobe));
  });
  return {round_up(bound.x), round_up(bound.y), round_up(bound.z)}; // of a sum
}

/// bound_by() with the maximum of n.l/|q|^2 over the cluster's box in one and exact, those of the
/// lobe and of emission as stated there. Since 0 <= truth <= bound, it bounds the error of any
/// estimate between 0 and it, too (Walter et al. 2005, section 4.1). Never below the supremum in
/// real numbers. Never NaN; +inf only where the supremum is, or where it exceeds the largest float.
template <class Features = AnyFeatures, class OneLobe>
[[nodiscard]] glm::vec3 contribution_bound(const LightTree& tree, std::uint32_t node,
                                           const ShadingPoint& point, const OneLobe& lobe) {
  return bound_by(JointSuprema<Features>(), tree, node, point, lobe);
}

/// The same by ProductSuprema.
template <class Features = AnyFeatures, class OneLobe>
[[nodiscard]] glm::vec3 product_bound(const LightTree& tree, std::uint32_t node,
                                      const ShadingPoint& point, const OneLobe& lobe) {
  return bound_by(ProductSuprema<Features>(), tree, node, point, lobe);
}

/// Lower bound of the cluster's contribution where nothing occludes: intensity min(emission)
/// diffuse/pi min(n.l falloff) over the cluster's box, the lobe left out. Rounded down: never above
/// the infimum in real numbers.
template <class Features = AnyFeatures>
[[nodiscard]] glm::vec3 contribution_lower_bound(const LightTree& tree, std::uint32_t node,
                                                 const ShadingPoint& point) {
  constexpr double deflate = 1 - 0x1p-26; // see contribution_bound()
  const glm::dvec3 bound = detail::over_kinds<Features>(tree, node, [&](std::uint32_t i) {
    const TreeNode& cluster = tree.node(i);
    const LightKind kind = Features::known(cluster.kind());
    const glm::vec3 from = viewed_from(kind, point.position());
    double geometric =
        min_cosine_times(point.normal(), from, cluster.box,
                         [&](double length2) {
                           return falloff<Features>(kind, length2, tree.min_distance2());
                         }) *
        point.inverse_normal_length() * deflate;
    if constexpr (Features::has_axes)
      if (geometric > 0 && (only(kind) & kinds_with_axis) != 0)
        geometric *= min_emission(kind, tree.emission(i), from, cluster.box) * deflate;
    return geometric == 0 ? glm::dvec3(0)
                          : glm::dvec3(point.material().diffuse) * std::numbers::inv_pi *
                                cluster.intensity * geometric;
  });
  return {round_down(bound.x), round_down(bound.y), round_down(bound.z)};
}

} // namespace lightcuts
