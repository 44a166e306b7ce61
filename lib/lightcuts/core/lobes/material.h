// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/cook_torrance.h>
#include <lightcuts/core/lobes/phong.h>
#include <lightcuts/core/lobes/ward.h>

namespace lightcuts {

/// Of a surface that is diffuse only.
struct NoLobe {
  static constexpr const char* name = "none";
  template <class Visitor>
  static constexpr void fields(Visitor&& /*field*/) {}

  void validate() const {}
  [[nodiscard]] glm::dvec3 evaluate(const Sight& /*sight*/) const { return glm::dvec3(0); }
  template <class BoxSight>
  [[nodiscard]] glm::dvec3 bound(const BoxSight& /*box*/) const {
    return glm::dvec3(0);
  }
  bool cover(const NoLobe& /*other*/) { return true; }
  bool operator==(const NoLobe&) const = default;
};

/// The glossy lobes there are. A new one is a record with a name and fields(), validate(),
/// evaluate() (f, 1/sr per channel), bound() (of f n.l falloff over a box), cover() and ==, in a
/// file of its own and in this line; oracle/truth/lobes wants its truth, and the C interface and
/// the window their part: the compiler asks for them.
using Lobe = std::variant<NoLobe, Phong, Ward, CookTorrance>;

/// How a surface reflects: f(l) = diffuse/pi + lobe(l), 1/sr per channel. Energy is conserved where
/// diffuse and the lobe's reflectance sum to at most 1, within the limits that Ward states. Cook
/// and Torrance's reflects up to 1 near the horizon whatever its f0: there the sum is at most
/// diffuse + 1.
struct Material {
  glm::vec3 diffuse{0}; ///< reflectance, >= 0
  Lobe lobe = {};

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("diffuse", &Material::diffuse, domain::not_negative);
    field("lobe", &Material::lobe, domain::optional);
  }
  [[nodiscard]] bool is_glossy() const { return !std::holds_alternative<NoLobe>(lobe); }
  bool operator==(const Material&) const = default;
};

/// Throws InputError, naming the field, where a value lies outside its domain.
void validate(const Material& material);

/// Lambert and a Phong lobe, which is left out where it is black.
[[nodiscard]] Material diffuse_and_phong(const glm::vec3& diffuse, const glm::vec3& specular,
                                         float exponent);

} // namespace lightcuts
