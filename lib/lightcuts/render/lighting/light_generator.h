// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Omni lights spread uniformly over a box, of random strength.
struct LightCloud {
  static constexpr std::uint32_t max_count = 100'000'000;

  std::uint32_t count = 0;     ///< number of lights, in [1, max_count]
  std::uint64_t seed = 1;      ///< the same seed gives the same bits
  glm::vec3 lo{0};             ///< corner of the box, metres
  glm::vec3 hi{0};             ///< opposite corner, >= lo in every component
  glm::vec3 intensity{1};      ///< of all lights together, W/sr, each >= 0
  bool random_colours = false; ///< each light has a tint of its own; the sum is still `intensity`
};

/// Adds the lights of the cloud to `lights`. Their strengths differ by a factor of up to 3 (and by
/// up to 5 more per channel if coloured); each lies in the closed box. Throws InputError, naming
/// the field, where the cloud leaves the domain given above or a component is not finite.
void generate(const LightCloud& cloud, LightSet& lights);

/// A cloud that suits a scene: the upper half of its box, kept 5 % of the box off the walls and the
/// ceiling; white; of an intensity that gives radiances about 1, whatever the scene's unit of
/// length. Throws InputError for a mesh without triangles.
[[nodiscard]] LightCloud default_cloud(const TriangleMesh& mesh, std::uint32_t count,
                                       std::uint64_t seed);

} // namespace lightcuts
