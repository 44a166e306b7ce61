// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/light_emission.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <lightcuts/render/scene/bounds.h>

#include <lightcuts/render/lighting/direction_sampling.h>

namespace lightcuts {
namespace {

using std::numbers::pi;

/// Solid angles of a spot, the rim's weighted with t^2: 2 pi times the integral over the cosine.
struct Cone {
  explicit Cone(const Light& light)
      : inner(2 * pi * (1 - double(light.cos_inner))),
        rim(2 * pi * (double(light.cos_inner) - light.cos_outer) / 3) {}
  double inner, rim;
};

double spot_cosine(const Light& light, double u, Random& random) {
  const Cone cone(light);
  const double x = u * (cone.inner + cone.rim);
  if (x < cone.inner) return 1 - x / cone.inner * (1 - double(light.cos_inner));
  // The largest of three uniform numbers has the density 3 t^2.
  const double t = std::max({random.unit_double(), random.unit_double(), random.unit_double()});
  return light.cos_outer + t * (double(light.cos_inner) - light.cos_outer);
}

} // namespace

LightEmission::LightEmission(const TriangleMesh& mesh) {
  const Box box = scene_bounds(mesh);
  centre_ = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  radius_ = 0.5 * diagonal_length(box);
}

glm::dvec3 LightEmission::power(const Light& light) const {
  const glm::dvec3 intensity(light.intensity);
  switch (light.kind) {
  case LightKind::omni:
    return 4 * pi * intensity;
  case LightKind::oriented:
    return pi * intensity;
  case LightKind::spot: {
    const Cone cone(light);
    return (cone.inner + cone.rim) * intensity;
  }
  case LightKind::directional:
    break;
  }
  return pi * radius_ * radius_ * intensity;
}

LightRay LightEmission::ray(const Light& light, const glm::dvec2& u, Random& random) const {
  // Rounding leaves axes off unit length.
  const auto unit = [](const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); };
  switch (light.kind) {
  case LightKind::omni:
    return {light.position, at_cosine({0, 1, 0}, 1 - 2 * u.x, u.y)};
  case LightKind::oriented: {
    // Off the surface on which the light lies, as far as surface_point() would for a
    // triangle as large as the scene.
    const glm::dvec3 axis = unit(light.axis);
    const glm::dvec3 off = glm::dvec3(light.position) + 0x1p-17 * radius_ * axis;
    return {glm::vec3(off), square_to_cosine(axis, u)};
  }
  case LightKind::spot:
    return {light.position, at_cosine(unit(light.axis), spot_cosine(light, u.x, random), u.y)};
  case LightKind::directional:
    break;
  }
  const glm::dvec3 towards = unit(light.position);
  const glm::dvec3 on_disc = about(towards, radius_ * std::sqrt(u.x), u.y);
  // A little farther than the sphere, so that nothing of the scene is behind.
  return {glm::vec3(centre_ + on_disc + 1.01 * radius_ * towards), -towards};
}

} // namespace lightcuts
