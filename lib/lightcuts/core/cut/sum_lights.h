// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include <glm/vec3.hpp>
#include <lightcuts/core/kernels/contribution.h>
#include <lightcuts/core/kernels/features.h>
#include <lightcuts/core/lights/light_set.h>

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
  const double min_distance2 = double(lights.min_distance()) * lights.min_distance();
  LightSum sum;
  const auto add_all = [&](auto features, const auto& lobe) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      const glm::dvec3 open = transfer<decltype(features)>(point, lobe, lights[i], min_distance2);
      if (open == glm::dvec3(0)) continue;
      ++sum.shadow_rays;
      if (visible(i)) sum.radiance += open * glm::dvec3(lights[i].intensity);
    }
  };
  with_features(lights, true, [&](auto features) {
    std::visit([&](const auto& lobe) { add_all(features, lobe); }, point.material().lobe);
  });
  return sum;
}

} // namespace lightcuts
