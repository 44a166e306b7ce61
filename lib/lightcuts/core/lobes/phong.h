// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/shading/box_sight.h>
#include <lightcuts/core/shading/sight.h>

namespace lightcuts {

/// Normalised Phong (Lafortune & Willems 1994):
///   f(l) = reflectance (exponent + 2)/(2 pi) cos(r,l)^exponent   where cos(r,l) > 0, else 0,
/// r being ShadingFrame::mirror(), the viewer's direction mirrored at the normal and rounded to
/// floats: they are what the lobe is about, here, in the oracle's truth and for plug-ins. With
/// reflectance 1 it reflects all light that comes along the normal, and less of other light.
struct Phong {
  static constexpr const char* name = "phong";
  static constexpr float max_exponent = 0x1p20F;

  glm::vec3 reflectance{0}; ///< >= 0; energy is conserved up to 1
  float exponent = 0;       ///< in [0, max_exponent]

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("reflectance", &Phong::reflectance, domain::not_negative);
    field("exponent", &Phong::exponent, domain::within(0, max_exponent));
  }

  /// Throws InputError, naming the field, where a value lies outside the domain given above.
  void validate() const;

  [[nodiscard]] glm::dvec3 evaluate(const Sight& sight) const {
    const double cosine = sight.mirror_cosine();
    if (cosine <= 0) return glm::dvec3(0);
    return glm::dvec3(reflectance) * (normalisation() * power(cosine, exponent));
  }

  /// The largest cos(r,l) over the box, exact, makes the largest f.
  template <class BoxSight>
  [[nodiscard]] glm::dvec3 bound(const BoxSight& box) const {
    const double cosine = box.max_mirror_cosine();
    if (cosine <= 0) return glm::dvec3(0);
    return lobe_bound(reflectance, std::max(normalisation() * power(cosine, exponent), 0x1p-760) *
                                       box.max_cosine_falloff);
  }

  /// Takes over the larger reflectance; whether the shapes are the same, without which it does not.
  bool cover(const Phong& other) {
    if (exponent != other.exponent) return false;
    reflectance = glm::max(reflectance, other.reflectance);
    return true;
  }
  bool operator==(const Phong&) const = default;

  /// (exponent + 2) / (2 pi): also the largest f per reflectance.
  [[nodiscard]] double normalisation() const {
    return (double(exponent) + 2) * (0.5 * std::numbers::inv_pi);
  }
};

} // namespace lightcuts
