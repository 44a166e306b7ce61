// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A cloud of points over the surfaces, each an oriented light in place of the light that the
/// surface around it reflects: one bounce of indirect light without tracing paths.
struct Surfels {
  static constexpr std::uint32_t max_count = 10'000'000;

  std::uint32_t count = 1000; ///< points, in [1, max_count]
  std::uint64_t seed = 1;     ///< the same seed gives the same bits
  unsigned threads = 0;       ///< 0: one per core; any number gives the same bits
};

/// Lights the points with what scene.lights holds now, shadow rays cast, adds a light for every
/// point and side that is lit, and to scene.notes what it did.
///
/// The points are spread uniformly over the area of all triangles: one in each of `count` equal
/// pieces of the sum of areas, those of a triangle evenly over it. Each stands for the area
/// A / count, A being the total. Both sides count, as they are both seen; a side that receives the
/// irradiance E (by its geometric normal) and has the diffuse reflectance a gets the intensity
/// a E / pi * A / count along that normal, W/sr. LightSet::min_distance clamps E, too. Specular
/// lobes reflect nothing here.
///
/// Conserved is the area exactly, and so the reflected power where a E does not vary; else the
/// power in expectation, and it converges with the count.
///
/// The scene must be valid (see validate()). Throws InputError where the count leaves its domain,
/// there is no light, no triangle has an area, or an intensity exceeds the largest float; no light
/// is added, then. Against bright spots around the lights see suggested_min_distance(). Takes time
/// in proportion to count times lights.
void add_surfels(Scene& scene, const Surfels& config);

} // namespace lightcuts
