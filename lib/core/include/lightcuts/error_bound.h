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

/// Upper bound, per channel, of the cluster's contribution to the radiance seen at the point,
/// whatever is visible:
///   intensity (diffuse/pi + specular (m+2)/(2 pi) max cos(r,l)^m) max(n.l / |q|^2),
/// each maximum over the cluster's box. Since 0 <= truth, estimate <= bound, it bounds the error of
/// any estimate made at a place in the box, too (Walter et al. 2005, section 4.1, with exact
/// maxima). Rounded up: never below the supremum in real numbers. Never NaN; +inf only where the
/// supremum is, or where it exceeds the largest float.
[[nodiscard]] inline glm::vec3 contribution_bound(const TreeNode& cluster,
                                                  const ShadingPoint& point) {
  // Makes up for all errors below: of the box bounds, power(), and some roundings.
  constexpr double inflate = 1 + 0x1p-26;
  static_assert(4 * box_bound_error + power_error + 0x1p-48 < 0x1p-26);

  const glm::vec3& x = point.position();
  const double geometric = max_cosine_over_distance2(point.normal(), x, cluster.box) *
                           point.inverse_normal_length() * inflate;
  if (geometric == 0) return glm::vec3(0);

  const Material& material = point.material();
  double lobe = 0;
  if (material.has_specular()) {
    const double cosine = max_cosine(point.mirror(), x, cluster.box);
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

} // namespace lightcuts
