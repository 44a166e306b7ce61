// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <type_traits>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/suprema.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/shading/box_sight.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// contribution_bound() is at most (1 + bound_excess) times the real expression it stands for, plus
/// one smallest subnormal float: 2^-23 from the last rounding, the rest before it.
inline constexpr double bound_excess = 0x1p-22;

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

/// intensity emitted (diffuse geometric/pi + shine), rounded up; 0 times infinity is 0, and a
/// product of positive numbers is positive.
inline glm::vec3 bound_of_product(const glm::dvec3& intensity, double emitted,
                                  const glm::vec3& diffuse, double geometric,
                                  const glm::dvec3& shine) {
  glm::vec3 bound;
  for (int c = 0; c < 3; ++c) {
    const double per_pi = diffuse[c] * std::numbers::inv_pi;
    const double reflected = (per_pi == 0 ? 0 : per_pi * geometric) + shine[c];
    const double sent = intensity[c] * emitted;
    bound[c] = reflected == 0 || sent == 0 ? 0.0F : round_up(std::max(reflected * sent, 0x1p-1000));
  }
  return bound;
}

} // namespace detail

/// Upper bound, per channel, of what the cluster, whose lights are of one kind, contributes to the
/// radiance seen at the point, whatever is visible, by the given suprema over its box:
///   intensity max(emission) (diffuse/pi max(n.l falloff) + max(lobe n.l falloff)) ,
/// lobe.bound() being the last of them. Rounded up. The suprema are asked in the way of
/// JointSuprema.
template <class Suprema, class OneLobe>
[[nodiscard]] glm::vec3 cluster_bound(const Suprema& suprema, const LightTree& tree,
                                      std::uint32_t i, const ShadingPoint& point,
                                      const OneLobe& lobe) {
  constexpr bool is_diffuse = std::is_same_v<OneLobe, NoLobe>;
  const TreeNode& cluster = tree.node(i);
  const LightKind kind = suprema.kind_of(cluster);
  const bool has_axes = has_axis(kind);
  const glm::vec3 from = viewed_from(kind, point.position());
  const double joint =
      suprema.max_cosine_falloff(kind, point.normal(), from, cluster.box, tree.min_distance2());
  if (joint == 0) return glm::vec3(0);
  const double geometric = joint * point.inverse_normal_length() * detail::bound_inflation;
  if (is_diffuse && !has_axes && geometric < std::numeric_limits<double>::infinity()) [[likely]]
    return detail::diffuse_bound(cluster.intensity, point.material().diffuse, geometric);
  double emitted = 1;
  if (has_axes) {
    emitted = suprema.max_emission(tree, i, kind, from);
    if (emitted == 0) return glm::vec3(0);
  }
  glm::dvec3 shine(0);
  if constexpr (!is_diffuse) {
    const double falloff = suprema.max_falloff(kind, from, cluster.box, tree.min_distance2());
    shine = lobe.bound(
        BoxSight{point, from, cluster.box, geometric, falloff * detail::bound_inflation});
  }
  return detail::bound_of_product(cluster.intensity, emitted, point.material().diffuse, geometric,
                                  shine);
}

/// A lobe bounded as if some light stood in its brightest direction: no cosine of it is looked at.
template <class OneLobe>
struct LobeAtItsPeak {
  const OneLobe& lobe;

  [[nodiscard]] glm::dvec3 bound(const BoxSight& sight) const {
    constexpr float most = std::numeric_limits<float>::max();
    const Box everywhere{glm::vec3(-most), glm::vec3(most)};
    return lobe.bound(
        BoxSight{sight.frame, sight.from, everywhere, sight.max_cosine_falloff, sight.max_falloff});
  }
};

/// Lower bound of what the cluster of one kind contributes where nothing occludes:
/// intensity min(emission) diffuse/pi min(n.l falloff) over its box, the lobe left out; not rounded
/// to float yet.
template <class Kind>
[[nodiscard]] glm::dvec3 cluster_lower_bound(const LightTree& tree, std::uint32_t i,
                                             const ShadingPoint& point) {
  constexpr double deflate = 1 - 0x1p-26; // see bound_inflation
  const TreeNode& cluster = tree.node(i);
  const glm::vec3 from = viewed_from(Kind::kind, point.position());
  double geometric = min_cosine_times(point.normal(), from, cluster.box,
                                      [&](double length2) {
                                        return falloff(Kind::kind, length2, tree.min_distance2());
                                      }) *
                     point.inverse_normal_length() * deflate;
  if constexpr (has_axis(Kind::kind))
    if (geometric > 0)
      geometric *= Kind::min_emission(tree.emission(i), DifferenceBox(from, cluster.box)) * deflate;
  return geometric == 0 ? glm::dvec3(0)
                        : glm::dvec3(point.material().diffuse) * std::numbers::inv_pi *
                              cluster.intensity * geometric;
}

} // namespace lightcuts
