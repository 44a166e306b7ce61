// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light_set.h>

#include <lightcuts/render/lighting/direction_sampling.h>
#include <lightcuts/render/lighting/random.h>

namespace lightcuts {

/// Where a ray of light starts, metres, and its unit direction.
struct LightRay {
  glm::vec3 origin;
  glm::dvec3 direction;
};

/// What light can reach: the sphere around a scene's box, metres.
struct Reach {
  glm::dvec3 centre;
  double radius;
};

/// What scenes know of a kind of light:
///   read(element, lights)        adds the light that an element of a scene file describes, see
///                                load_scene_json(), after its "type"; of a kind that files
///                                describe read(element, lights, files);
///   add(light, random, lights)   adds one of a cloud: an omni light made one of this kind;
///   power(light, reach)          W per intensity, see VirtualPointLights;
///   ray(light, u, random, reach) drawn in proportion to the power emitted along it: from a point
///                                of the unit square and, for what needs more of it, chance.
template <LightKind kind>
struct KindInScenes {
  static_assert(kind == LightKind(-1),
                "a light kind without its part in scenes: write lighting/kinds/<kind>.h, and "
                "include it in lighting/light_kinds.h");
};

namespace detail {

/// Uniform over the directions, without sine or cosine: by rejection.
inline glm::vec3 random_direction(Random& random) {
  for (;;) {
    glm::vec3 v;
    for (int i = 2; i >= 0; --i) v[i] = random.between(-1, 1);
    const float squared = v.x * v.x + v.y * v.y + v.z * v.z;
    if (squared > 0.01F && squared <= 1) return v / std::sqrt(squared);
  }
}

/// Mostly downwards: uniform directions and the vertical, added.
inline glm::vec3 random_axis(Random& random) {
  const glm::dvec3 v = glm::dvec3(random_direction(random)) + glm::dvec3(0, -1.05, 0);
  return glm::vec3(glm::normalize(v));
}

/// Rounding leaves axes off unit length.
inline glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

} // namespace detail

} // namespace lightcuts
