// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/images/environment_map.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Directional lights in place of an environment map.
struct EnvironmentLights {
  static constexpr std::uint32_t max_count = 10'000'000;

  double turn = 0; ///< of the map about +y, degrees, in [-360, 360]: what was along +z comes to lie
                   ///< towards +x
  bool visible = false;       ///< whether the camera sees the map where it sees no surface
  std::uint32_t count = 1024; ///< number of lights, in [1, max_count]; fewer where fewer pixels of
                              ///< the map are lit
};

/// Adds the lights to scene.lights, and to scene.notes what it did; where the camera is to see the
/// map, it becomes one of scene.backdrops.
///
/// The map is cut into rectangles of pixels, the one with the largest luminance * solid angle *
/// squared extent first, each across its longer side where that halves its luminance: after
/// Debevec, "A median cut algorithm for light probe sampling" (2005), but without spending lights
/// on what is small already. Every rectangle becomes a light that carries its exact sum of radiance
/// * solid angle per channel, W/m^2, so that the total over the map is conserved but for the
/// rounding of each light to float. It shines from the luminance-weighted mean of the pixels'
/// directions. Nothing is random: same map, same bits.
///
/// Throws InputError where the map is not valid (see validate()), the count or the turn leaves its
/// domain, or an irradiance exceeds the largest float; no light is added, then.
void add_environment_lights(Scene& scene, const EnvironmentMap& map,
                            const EnvironmentLights& config);

} // namespace lightcuts
