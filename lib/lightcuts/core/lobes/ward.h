// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/numerics/exponential.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/shading/box_sight.h>
#include <lightcuts/core/shading/sight.h>

namespace lightcuts {

/// Isotropic Ward (1992):
///   f(l) = reflectance exp(-tan^2(n,h) / alpha^2) / (4 pi alpha^2 sqrt(n.l n.v))
/// for viewers above the horizon, else 0. Energy: with reflectance 1 it reflects all light that
/// comes along the normal (less for alpha above 0.1), about n.v of the light from elsewhere, but,
/// by this definition, more than all of it near the horizon: nowhere with n.v above 0.0046 (within
/// 89.73 degrees of the normal), and up to min(0.068, 0.37 alpha^1.5) / sqrt(n.v) beyond.
struct Ward {
  static constexpr const char* name = "ward";
  static constexpr float min_alpha = 0x1p-14F;

  glm::vec3 reflectance{0}; ///< >= 0; energy is conserved up to 1, but see above
  float alpha = 0.1F;       ///< standard deviation of the surface's slope, in [min_alpha, 1]

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("reflectance", &Ward::reflectance, domain::not_negative);
    field("alpha", &Ward::alpha, domain::within(min_alpha, 1));
  }

  /// Throws InputError, naming the field, where a value lies outside the domain given above.
  void validate() const;

  [[nodiscard]] glm::dvec3 evaluate(const Sight& sight) const {
    const double viewer = sight.frame().viewer_cosine();
    if (viewer <= 0) return glm::dvec3(0);
    const double a2 = double(alpha) * alpha;
    return glm::dvec3(reflectance) *
           (exp_of_minus(sight.half_tangent2() / a2) * peak(viewer) / std::sqrt(sight.cosine()));
  }

  /// f n.l falls off with tan(n,h) and grows with sqrt(n.l): the square root of n.l falloff and
  /// falloff at their largest.
  template <class BoxSight>
  [[nodiscard]] glm::dvec3 bound(const BoxSight& box) const {
    const double viewer = box.least_viewer_cosine();
    if (viewer <= 0) return glm::dvec3(0);
    const double a2 = double(alpha) * alpha;
    const double lobe = std::max(exp_of_minus(box.min_half_tangent2() / a2), 0x1p-760);
    return lobe_bound(reflectance, lobe * peak(viewer) * std::sqrt(box.max_cosine_falloff) *
                                       std::sqrt(box.max_falloff));
  }

  /// Takes over the larger reflectance; whether the shapes are the same, without which it does not.
  bool cover(const Ward& other) {
    if (alpha != other.alpha) return false;
    reflectance = glm::max(reflectance, other.reflectance);
    return true;
  }
  bool operator==(const Ward&) const = default;

  /// The largest f sqrt(n.l) per reflectance.
  [[nodiscard]] double peak(double viewer_cosine) const {
    return 0.25 * std::numbers::inv_pi / (double(alpha) * alpha * std::sqrt(viewer_cosine));
  }
};

} // namespace lightcuts
