// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/exact_dot.h>
#include <lightcuts/rounding.h>
#include <lightcuts/shading_point.h>

namespace lightcuts {

/// Relative error of transfer(), where the result is above 10^-150: power(), two dot products, a
/// few roundings.
inline constexpr double transfer_error = 0x1p-28;

/// The factor of the Phong lobe without its cosine power: (exponent + 2) / (2 pi).
[[nodiscard]] inline double phong_normalisation(float exponent) {
  return (double(exponent) + 2) * (0.5 * std::numbers::inv_pi);
}

/// Radiance per unit of radiant intensity, 1/m^2 sr, that an unoccluded omni light at y sends to
/// the viewer of `point`: material(l) max(0, n.l) / |q|^2, q = y - x, l = q/|q|. A light exactly at
/// the shading point has no direction and sends 0. Never NaN or negative.
[[nodiscard]] inline glm::dvec3 transfer(const ShadingPoint& point, const glm::vec3& y) {
  const glm::vec3& x = point.position();
  const double n_dot_q = dot_between(point.normal(), x, y);
  if (n_dot_q <= 0) return glm::dvec3(0);
  const glm::dvec3 q = glm::dvec3(y) - glm::dvec3(x);
  const double distance2 = q.x * q.x + q.y * q.y + q.z * q.z;
  const double distance = std::sqrt(distance2);
  const double geometric = n_dot_q * point.inverse_normal_length() / (distance2 * distance);

  const Material& material = point.material();
  glm::dvec3 brdf = glm::dvec3(material.diffuse) * std::numbers::inv_pi;
  if (material.has_specular()) {
    const double r_dot_q = dot_between(point.mirror(), x, y);
    if (r_dot_q > 0) {
      const double cosine = r_dot_q * point.inverse_mirror_length() / distance;
      brdf += glm::dvec3(material.specular) *
              (phong_normalisation(material.exponent) * power(cosine, material.exponent));
    }
  }
  return brdf * geometric;
}

} // namespace lightcuts
