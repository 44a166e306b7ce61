// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/blocks/neighbours.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/numbers/dice.h>

namespace lightcuts {

/// A square of side x side points of a floor, 0.1 m apart, each in the pixel of its indices.
inline std::vector<BlockPoint> floor_points(unsigned side,
                                            const Material& material = {glm::vec3(0.5F), {}}) {
  std::vector<BlockPoint> points;
  for (unsigned y = 0; y < side; ++y)
    for (unsigned x = 0; x < side; ++x)
      points.push_back(
          {ShadingPoint({0.1F * float(x), 0, 0.1F * float(y)}, {0, 1, 0}, {0, 1, 0}, material),
           {float(x), float(y)}});
  return points;
}

inline std::vector<const ShadingPoint*> pointers_to(const std::vector<BlockPoint>& points) {
  std::vector<const ShadingPoint*> pointers;
  for (const BlockPoint& p : points) pointers.push_back(&p.point);
  return pointers;
}

/// Omni lights of various intensities in a box above the floor.
inline LightSet lights_above(unsigned count, std::uint64_t seed = 1) {
  gen::Dice dice(seed);
  LightSet lights;
  for (unsigned i = 0; i < count; ++i)
    lights.add_omni(
        {float(dice.uniform(-6, 6)), float(dice.uniform(4, 8)), float(dice.uniform(-6, 6))},
        glm::vec3(float(dice.uniform(0.1, 2)), 1, float(dice.uniform(0.1, 2))));
  return lights;
}

} // namespace lightcuts
