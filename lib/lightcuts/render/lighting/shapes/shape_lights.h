// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Light shapes as UsdLux has them (RectLight, DiskLight, SphereLight, CylinderLight): diffuse
/// emitters of one radiance all over, apart from the scene's surfaces. Nothing sees or shadows
/// them.
enum class ShapeKind : std::uint8_t {
  rectangle, ///< one-sided, towards its axis
  disc,      ///< one-sided, towards its axis
  sphere,    ///< outwards
  tube       ///< the side of a cylinder about its axis, outwards; its ends are dark
};
[[nodiscard]] constexpr std::array<const char*, 4> names_of(ShapeKind /*any*/) {
  return {"rectangle", "disc", "sphere", "tube"};
}

/// Oriented lights in place of a shape that emits.
struct ShapeLights {
  static constexpr std::uint32_t max_count = 10'000'000;

  ShapeKind kind = ShapeKind::rectangle;
  glm::vec3 centre{0};      ///< metres
  glm::vec3 axis{0, -1, 0}; ///< unit: the normal of a rectangle or disc, along a tube
  glm::vec3 along{1, 0, 0}; ///< unit, about perpendicular to the axis: a rectangle's first side
  glm::vec2 sides{1, 1};    ///< of a rectangle, metres, > 0: along `along` and across
  float radius = 1;         ///< of the others, metres, > 0
  float length = 1;         ///< of a tube, metres, > 0
  glm::vec3 radiance{0};    ///< W/(m^2 sr), finite, >= 0
  std::uint32_t count = 64; ///< number of lights, in [1, max_count]
  std::uint64_t seed = 1;   ///< the same seed gives the same bits
};

/// What of it emits, m^2.
[[nodiscard]] double area_of(const ShapeLights& shape);

/// Adds the lights to scene.lights, and to scene.notes what it did. Each stands at a point for an
/// equal part of the area: the image of a shifted Hammersley set under a map from the unit square
/// that keeps areas. Their intensities along their normals, radiance area / count, sum to radiance
/// area, and so the power to pi radiance area, per channel but for the rounding of one light to
/// float: each makes up for the rounding of those before.
///
/// Throws InputError where a field leaves its domain or an intensity exceeds the largest float; no
/// light is added, then.
void add_shape_lights(Scene& scene, const ShapeLights& shape);

} // namespace lightcuts
