// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace lightcuts {

/// Lambert plus normalised Phong (Lafortune & Willems 1994):
///   f(l) = diffuse/pi + specular (exponent+2)/(2 pi) cos(r,l)^exponent  where cos(r,l) > 0,
/// r being the viewer's direction mirrored at the normal; the second term is 0 elsewhere.
struct Material {
  static constexpr float max_exponent = 0x1p20F;

  glm::vec3 diffuse{0};  ///< reflectance, >= 0; energy is conserved while diffuse + specular <= 1
  glm::vec3 specular{0}; ///< reflectance of the lobe, >= 0
  float exponent = 0;    ///< in [0, max_exponent]

  [[nodiscard]] bool has_specular() const {
    return specular.x > 0 || specular.y > 0 || specular.z > 0;
  }
};

/// Throws InputError, naming the field, where a value lies outside the domain given above.
void validate(const Material& material);

} // namespace lightcuts
