// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>

#include <glm/vec3.hpp>
#include <lightcuts/box_bounds.h>
#include <lightcuts/contribution.h>
#include <lightcuts/light_tree.h>
#include <lightcuts/rounding.h>
#include <lightcuts/shading_point.h>

namespace lightcuts {

/// contribution_bound() is at most (1 + bound_excess) times the real expression it stands for, plus
/// one smallest subnormal float: 2^-23 from the last rounding, the rest before it.
inline constexpr double bound_excess = 0x1p-22;

namespace detail {

// Makes up for the errors of the box bounds, power(), and some roundings.
inline constexpr double bound_inflation = 1 + 0x1p-26;
static_assert(4 * box_bound_error + power_error + 0x1p-48 < 0x1p-26);

/// intensity (diffuse/pi + specular (m+2)/(2 pi) max cos(r,l)^m) geometric, rounded up.
inline glm::vec3 bound_with(double geometric, const TreeNode& cluster, const ShadingPoint& point) {
  if (geometric == 0) return glm::vec3(0);
  const Material& material = point.material();
  double lobe = 0;
  if (material.has_specular()) {
    const double cosine = max_cosine(point.mirror(), point.position(), cluster.box);
    if (cosine > 0)
      // power() underflows where the real value is positive. This stays above 0 times the smallest
      // reflectance and intensity (2^-298), and below 2^-149 times the largest of all the rest
      // (2^602: lobe 2^17, reflectance 2^128, 2^31 lights of 2^128, 1/|q|^2 2^298).
      lobe = phong_normalisation(material.exponent) *
             std::max(power(cosine * point.inverse_mirror_length(), material.exponent), 0x1p-760);
  }
  glm::vec3 bound;
  for (int c = 0; c < 3; ++c) {
    const double factor =
        (material.diffuse[c] * std::numbers::inv_pi + material.specular[c] * lobe) *
        cluster.intensity[c];
    // 0 * inf is 0 here, and a product of positive numbers is positive.
    bound[c] = factor == 0 ? 0.0F : round_up(std::max(factor * geometric, 0x1p-1000));
  }
  return bound;
}

} // namespace detail

/// Upper bound, per channel, of the cluster's contribution to the radiance seen at the point,
/// whatever is visible:
///   intensity (diffuse/pi + specular (m+2)/(2 pi) max cos(r,l)^m) max(n.l / |q|^2),
/// each maximum over the cluster's box. Since 0 <= truth <= bound, it bounds the error of any
/// estimate between 0 and it, too (Walter et al. 2005, section 4.1, with exact maxima). Rounded up:
/// never below the supremum in real numbers. Never NaN; +inf only where the supremum is, or where
/// it exceeds the largest float.
[[nodiscard]] inline glm::vec3 contribution_bound(const TreeNode& cluster,
                                                  const ShadingPoint& point) {
  return detail::bound_with(
      max_cosine_over_distance2(point.normal(), point.position(), cluster.box) *
          point.inverse_normal_length() * detail::bound_inflation,
      cluster, point);
}

/// The same with separate maxima of n.l and 1/|q|^2, as the paper has it: looser.
[[nodiscard]] inline glm::vec3 product_bound(const TreeNode& cluster, const ShadingPoint& point) {
  const glm::vec3& x = point.position();
  const double cosine = max_cosine(point.normal(), x, cluster.box);
  if (cosine == 0) return glm::vec3(0);
  return detail::bound_with(cosine * point.inverse_normal_length() * detail::bound_inflation /
                                min_distance2(x, cluster.box),
                            cluster, point);
}

/// Lower bound of the cluster's contribution where nothing occludes: intensity diffuse/pi
/// min(n.l/|q|^2) over the cluster's box, the lobe left out. Rounded down: never above the infimum
/// in real numbers.
[[nodiscard]] inline glm::vec3 contribution_lower_bound(const TreeNode& cluster,
                                                        const ShadingPoint& point) {
  constexpr double deflate = 1 - 0x1p-26; // see contribution_bound()
  const double geometric =
      min_cosine_over_distance2(point.normal(), point.position(), cluster.box) *
      point.inverse_normal_length() * deflate;
  glm::vec3 bound(0);
  if (geometric == 0) return bound;
  for (int c = 0; c < 3; ++c)
    bound[c] = round_down(point.material().diffuse[c] * std::numbers::inv_pi *
                          cluster.intensity[c] * geometric);
  return bound;
}

} // namespace lightcuts
