// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <lightcuts/core/lights/light.h>

namespace lightcuts::viz {

/// Lights per full-screen pass at most: 12 KiB, of the 16 that any uniform block may have.
inline constexpr std::size_t max_light_batch = 256;

/// A light of any kind for one formula without branches, laid out as std140 has it. With q =
/// place.xyz - place.w p, l = q/|q| and t = clamp(ramp.w - ramp.xyz . l, 0, 1), the light sends
/// intensity mix(t, t^2, squared) towards the point p.
struct GpuLight {
  glm::vec4 place;     ///< position relative to the camera, 1; or the direction towards it, 0
  glm::vec4 intensity; ///< W/sr (directional: W/m^2); w: squared, 1 for spots, else 0
  glm::vec4 ramp;      ///< the axis and the angles' share
};
static_assert(sizeof(GpuLight) == 48);

/// `camera` in metres: subtracted in double, before anything is rounded.
[[nodiscard]] GpuLight gpu_light(const Light& light, const glm::dvec3& camera);

} // namespace lightcuts::viz
