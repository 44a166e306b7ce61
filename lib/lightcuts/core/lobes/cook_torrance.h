// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/shading/box_sight.h>
#include <lightcuts/core/shading/sight.h>

namespace lightcuts {

/// Cook & Torrance (1982) as glTF 2.0 has it: f(l) = F D V, with T = tan^2(n,h),
///   D = alpha^2 (1 + T)^2 / (pi (alpha^2 + T)^2)                        (GGX, Walter et al. 2007),
///   V = 1 / (2 (n.l sqrt(alpha^2 + (1 - alpha^2) (n.v)^2)
///             + n.v sqrt(alpha^2 + (1 - alpha^2) (n.l)^2)))   (Smith, height-correlated, Heitz
///             2014),
///   F = f0 + (1 - f0) (1 - v.h)^5                                                (Schlick 1994)
/// for viewers above the horizon, else 0. Conserves energy for every f0 and alpha; what is
/// scattered between the facets is lost: with f0 = alpha = 1, 69 % of the light that comes along
/// the normal.
struct CookTorrance {
  static constexpr const char* name = "cook-torrance";
  static constexpr float min_alpha = 0x1p-14F;

  glm::vec3 f0{0};    ///< reflectance at normal incidence, in [0, 1]
  float alpha = 0.5F; ///< width of the distribution of normals, in [min_alpha, 1]; glTF's
                      ///< roughness squared

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("f0", &CookTorrance::f0, domain::within(0, 1));
    field("alpha", &CookTorrance::alpha, domain::within(min_alpha, 1));
  }

  /// Throws InputError, naming the field, where a value lies outside the domain given above.
  void validate() const;

  [[nodiscard]] glm::dvec3 evaluate(const Sight& sight) const {
    const double viewer = sight.frame().viewer_cosine();
    if (viewer <= 0) return glm::dvec3(0);
    return fresnel(sight.schlick()) *
           (distribution(sight.half_tangent2()) * visibility(sight.cosine(), viewer));
  }

  /// D falls with T, F with v.h, V with n.l, while n.l V rises: so f n.l falloff is at most
  ///   D F min(V(least n.l) max(n.l falloff), V(1 or less) n.l max(falloff)) .
  template <class BoxSight>
  [[nodiscard]] glm::dvec3 bound(const BoxSight& box) const {
    const double viewer = box.least_viewer_cosine();
    if (viewer <= 0) return glm::dvec3(0);
    const double most = box.max_cosine_quickly(), between = box.min_between_cosine_quickly();
    const double shadowed =
        std::min(visibility(box.min_cosine_quickly(), viewer) * box.max_cosine_falloff,
                 most * visibility(most, viewer) * box.max_falloff);
    const double lobe = distribution(box.min_half_tangent2(most, between)) * shadowed;
    const glm::dvec3 f = fresnel(max_schlick(between));
    glm::dvec3 result;
    for (int c = 0; c < 3; ++c) result[c] = f[c] * std::max(lobe, 0x1p-700);
    return result;
  }

  /// Takes over the larger reflectance; whether the shapes are the same, without which it does not.
  bool cover(const CookTorrance& other) {
    if (alpha != other.alpha) return false;
    f0 = glm::max(f0, other.f0);
    return true;
  }
  bool operator==(const CookTorrance&) const = default;

  [[nodiscard]] double distribution(double tangent2) const {
    const double a2 = double(alpha) * alpha;
    const double ratio = (1 + tangent2) / (a2 + tangent2);
    return a2 * std::numbers::inv_pi * ratio * ratio;
  }

  [[nodiscard]] double visibility(double light_cosine, double viewer_cosine) const {
    const double a2 = double(alpha) * alpha;
    const auto masked = [a2](double cosine) { return std::sqrt(a2 + (1 - a2) * cosine * cosine); };
    return 0.5 / (light_cosine * masked(viewer_cosine) + viewer_cosine * masked(light_cosine));
  }

  [[nodiscard]] glm::dvec3 fresnel(double schlick) const {
    return glm::dvec3(f0) + (1.0 - glm::dvec3(f0)) * schlick;
  }
};

} // namespace lightcuts
