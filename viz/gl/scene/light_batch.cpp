// SPDX-License-Identifier: MIT
#include <viz/gl/scene/light_batch.h>

#include <glm/geometric.hpp>

namespace lightcuts::viz {
namespace {

glm::vec4 ramp_of(const Light& light) {
  if (!has_axis(light.kind)) return {0, 0, 0, 1};
  const glm::dvec3 axis = glm::normalize(glm::dvec3(light.axis));
  if (light.kind == LightKind::oriented) return glm::vec4(axis, 0);
  const double scale = 1 / (double(light.cos_inner) - light.cos_outer);
  return glm::vec4(scale * axis, -scale * light.cos_outer);
}

} // namespace

GpuLight gpu_light(const Light& light, const glm::dvec3& camera) {
  const bool far = is_at_infinity(light.kind);
  const glm::dvec3 place = glm::dvec3(light.position) - (far ? glm::dvec3(0) : camera);
  return {glm::vec4(place, far ? 0 : 1),
          glm::vec4(light.intensity, light.kind == LightKind::spot ? 1 : 0), ramp_of(light)};
}

} // namespace lightcuts::viz
