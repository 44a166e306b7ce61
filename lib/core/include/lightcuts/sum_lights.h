// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/contribution.h>
#include <lightcuts/light_set.h>

namespace lightcuts {

/// What all lights together send to the viewer, and the shadow rays that took.
struct LightSum {
  glm::dvec3 radiance{0};
  std::uint32_t shadow_rays = 0;
};

/// Every light on its own: exact but for rounding (relative error transfer_error + N 2^-53), and
/// the faster way where lights are few. visible(i) as for CutSelector.
template <class Visible>
[[nodiscard]] LightSum sum_lights(const LightSet& lights, const ShadingPoint& point,
                                  Visible&& visible) {
  LightSum sum;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const glm::dvec3 open = transfer(point, lights[i].position);
    if (open == glm::dvec3(0)) continue;
    ++sum.shadow_rays;
    if (visible(i)) sum.radiance += open * glm::dvec3(lights[i].intensity);
  }
  return sum;
}

} // namespace lightcuts
