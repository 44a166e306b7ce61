// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Oriented lights in place of the surfaces that emit light (Surface::emission).
struct AreaLights {
  static constexpr std::uint32_t max_count = 100'000'000;

  std::uint32_t count = 1000; ///< number of lights, in [1, max_count]; more where that is fewer
                              ///< than there are emissive triangles, as each gets at least one
  std::uint64_t seed = 1;     ///< the same seed gives the same bits
};

/// Adds the lights to scene.lights, and to scene.notes what it did.
///
/// Their number per triangle is in proportion to its power; on each they are spread uniformly and
/// evenly (a shifted Hammersley set), and lie on it or, by the rounding to float, in front of it,
/// so that shadow rays meet it beyond shadow_ray_gap. Triangles emit one-sidedly, towards where
/// their corners run counter-clockwise, although the camera sees both sides emit.
///
/// Where a texture multiplies the emission, each light stands for a part of the triangle of equal
/// power, and has exactly that part's intensity: see TexturedEmitter.
///
/// Of the n lights of any other triangle of area A and radiance L each has the intensity L A / n
/// along the normal, W/sr: together the triangle's power pi L A, but for the rounding of each to
/// float.
///
/// The scene must be valid (see validate()). Throws InputError where the count leaves its domain,
/// no triangle with an area emits, or an intensity exceeds the largest float; no light is added,
/// then.
void add_area_lights(Scene& scene, const AreaLights& config);

} // namespace lightcuts
