// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <variant>

#include <glm/vec3.hpp>
#include <lightcuts/core/kinds/light_kinds.h>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/shading/sight.h>

namespace lightcuts {

/// Relative error of transfer() where the result is above least_transfer; below that it is off by
/// no more than that. For the lobe and the kind that err most together it is below 2^-27. One by
/// one:
///
/// n.l, diffuse surfaces, falloff: 2^-34. dot_error and a few roundings of 2^-53.
/// Oriented lights: 2^-34, likewise. Spots: 2^-31, the square of a ramp that errs by 2^-33.
/// Luminaires: 2^-31, see Luminaire::emission().
/// Phong, about ShadingFrame::mirror(): 2^-28. cos(r,l) errs by 2^-50, and by 2^-34 of it however
///   small it is; the exponent is at most 2^20, and 280/ln(1/cos) where anything is left of the
///   power.
/// Ward: 2^-27.3. T = tan(n,h) errs by 2^-47.2 and 2^-41 T, so that T^2/alpha^2 does by 2 T/alpha
///   times the one over alpha, and 2 T^2/alpha^2 times the other. 1/alpha is at most 2^14, and
///   T/alpha 700^0.5 where anything is left of the exponential.
/// Cook-Torrance: 2^-30. V is of two cosines, and F errs by 2^-31; D does by the two errors of T
///   times 4 T/(alpha^2 + T^2), at most 2/alpha, and 4.
inline constexpr double transfer_error = 0x1p-26;

/// From here down lobes may lose their digits or vanish: e^-700 beside the largest reflectance,
/// 1/d^2 and 1/(alpha^2 (n.v)^0.5) is below it. Nothing is left of it beside the smallest float
/// when it is multiplied with the largest intensity.
inline constexpr double least_transfer = 1e-120;

/// How intensity falls off with the distance: 1/max(d^2, min_distance^2), 1 for directional lights.
[[nodiscard]] inline double falloff(LightKind kind, double distance2, double min_distance2) {
  return is_at_infinity(kind) ? 1 : 1 / std::max(distance2, min_distance2);
}

/// Radiance that reaches the viewer of a point by way of `sight`, per unit of intensity that is
/// sent there: (diffuse/pi + lobe(l)) n.l falloff. Something exactly at the point has no direction
/// and sends 0. Never NaN or negative.
template <class OneLobe>
[[nodiscard]] glm::dvec3 reflected(const ShadingPoint& point, const OneLobe& lobe,
                                   const Sight& sight, LightKind kind, double min_distance2) {
  if (sight.below_horizon()) return glm::dvec3(0);
  const glm::dvec3 brdf =
      glm::dvec3(point.material().diffuse) * std::numbers::inv_pi + lobe.evaluate(sight);
  return brdf * (sight.cosine() * falloff(kind, sight.distance2(), min_distance2));
}

/// Radiance per unit of intensity that the unoccluded light of this kind sends to the viewer of the
/// point; lobe is that of the point's material.
template <class Kind, class OneLobe>
[[nodiscard]] glm::dvec3 transfer(const ShadingPoint& point, const OneLobe& lobe,
                                  const Light& light, double min_distance2) {
  const Sight sight(point, Kind::kind, light.position);
  return reflected(point, lobe, sight, Kind::kind, min_distance2) *
         Kind::emission(light, point.position());
}

/// transfer() of any light to a point of any material; min_distance as of LightSet.
[[nodiscard]] glm::dvec3 transfer(const ShadingPoint& point, const Light& light,
                                  float min_distance = 0);

} // namespace lightcuts
