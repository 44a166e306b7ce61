// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Virtual point lights: oriented lights in place of the light that surfaces reflect (Keller,
/// "Instant radiosity", 1997).
struct VirtualPointLights {
  static constexpr std::uint32_t max_paths = 100'000'000;
  static constexpr std::uint32_t max_bounces = 1000;

  std::uint32_t paths = 1000; ///< traced from the scene's lights, in [1, max_paths]
  std::uint32_t bounces = 10; ///< longest path, in reflections, in [1, max_bounces]
  std::uint64_t seed = 1;     ///< the same seed gives the same bits
};

/// Traces light from the lights that scene.lights holds now, adds a light wherever it is reflected,
/// and to scene.notes what it did.
///
/// Paths are shared out over the lights in proportion to their power, stratified: the mean over the
/// channels of 4 pi I (omni), pi I (oriented), the integral of I t^2 over the cone (spot), or
/// E pi R^2 (directional: the disc that covers the sphere of radius R around the scene's box; much
/// of that may miss the scene). They start uniformly, with density cosine / pi, in proportion to
/// t^2, or uniformly over the disc. A path with the flux F that hits a surface of diffuse
/// reflectance a adds a light of intensity F a / pi along the geometric normal of the side that it
/// hit, and goes on from there (density cosine / pi) with probability q = max_c(F_c a_c) / max_c
/// F_c, at most 1, and the flux F a / q. Specular lobes reflect nothing here.
///
/// Conserved is, per channel, the expected power that surfaces reflect, summed up to `bounces`
/// reflections: in a closed diffuse room of reflectance a around lights of power P the lights of
/// reflection k have a^k P together. The first has that exactly where a does not vary.
///
/// The scene must be valid (see validate()). Throws InputError where a field leaves its domain, no
/// light has any power, or an intensity exceeds the largest float; no light is added, then. Against
/// bright spots around the lights see suggested_min_distance().
void add_virtual_point_lights(Scene& scene, const VirtualPointLights& config);

} // namespace lightcuts
