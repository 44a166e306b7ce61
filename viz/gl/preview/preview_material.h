// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/material.h>

namespace lightcuts::viz {

/// A material in the terms of the preview's shader: Lambert and one lobe by Cook and Torrance.
struct PreviewMaterial {
  glm::vec3 diffuse{0}; ///< reflectance
  glm::vec3 f0{0};      ///< of CookTorrance, in [0, 1]
  float alpha = 0;      ///< of CookTorrance, in [min_alpha, 1]; 0: no lobe
};

/// Exact for diffuse materials and for CookTorrance. Other lobes become the one that looks nearest,
/// with their reflectance, clamped to [0, 1], as f0:
///   Phong of exponent m: alpha = sqrt(2 / (m + 2)), the slope's width that gives the same falloff
///                        of D(n,h) near the peak (Walter et al. 2007, for Blinn's form);
///   Ward: its alpha.
[[nodiscard]] PreviewMaterial preview_material(const Material& material);

} // namespace lightcuts::viz
