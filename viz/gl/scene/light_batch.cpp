// SPDX-License-Identifier: MIT
#include <viz/gl/scene/light_batch.h>

#include <numbers>

#include <glm/geometric.hpp>
#include <lightcuts/render/lighting/profiles/profile_light.h>

namespace lightcuts::viz {
namespace {

glm::vec4 ramp_of(const Light& light) {
  if (!has_axis(light.kind)) return {0, 0, 0, 1};
  const glm::dvec3 axis = glm::normalize(glm::dvec3(light.axis));
  if (light.kind == LightKind::oriented) return glm::vec4(axis, 0);
  // The preview knows cosines and no tables: as bright as the profile is in the mean.
  if (light.kind == LightKind::profile)
    return {0, 0, 0, solid_share(light.profile.table()) / (4 * std::numbers::pi)};
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
