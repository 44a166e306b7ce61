// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/light_emission.h>

#include <lightcuts/render/lighting/light_kinds.h>
#include <lightcuts/render/scene/bounds.h>

namespace lightcuts {

LightEmission::LightEmission(const TriangleMesh& mesh) {
  const Box box = scene_bounds(mesh);
  reach_ = {0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi)), 0.5 * diagonal_length(box)};
}

glm::dvec3 LightEmission::power(const Light& light) const {
  return with_kind_in_scenes(light.kind, [&](auto kind) { return kind.power(light, reach_); }) *
         glm::dvec3(light.intensity);
}

LightRay LightEmission::ray(const Light& light, const glm::dvec2& u, Random& random) const {
  return with_kind_in_scenes(light.kind,
                             [&](auto kind) { return kind.ray(light, u, random, reach_); });
}

} // namespace lightcuts
