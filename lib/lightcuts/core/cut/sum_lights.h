// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/cut/visibility.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>

namespace lightcuts {

/// What all lights together send to the viewer, and the shadow rays that took.
struct LightSum {
  glm::dvec3 radiance{0};
  std::uint32_t shadow_rays = 0;
};

/// Every light on its own: exact but for rounding (relative error transfer_error + N 2^-53), and
/// the faster way where lights are few. visible(i) as for CutSelector, for lights that would
/// contribute.
[[nodiscard]] LightSum sum_lights(const LightSet& lights, const ShadingPoint& point,
                                  Visibility visible);

} // namespace lightcuts
