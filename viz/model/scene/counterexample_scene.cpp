// SPDX-License-Identifier: MIT
#include <viz/model/scene/counterexample_scene.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts::viz {
namespace {

/// Farther from the origin, metres, floats leave no room for a camera.
constexpr float farthest = 1e15F;

/// Half the square's side: of the order of the distance to the nearest light, within what floats
/// around the point can tell apart.
float half_side(const oracle::Case& on, const glm::vec3& at) {
  double nearest = 1e30;
  for (const Light& light : on.lights)
    if (!is_at_infinity(light.kind))
      if (const double d = glm::distance(glm::dvec3(light.position), glm::dvec3(at)); d > 0)
        nearest = std::min(nearest, d);
  if (nearest == 1e30) nearest = 1;
  const double least = 0x1p-12 * double(glm::length(at));
  return float(std::clamp(nearest, std::max(least, 1e-12), 1e12));
}

/// A unit vector across n.
glm::vec3 across(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(n, axis));
}

void add_square(Scene& scene, const gen::View& view, float side) {
  const glm::vec3 u = side * across(view.normal);
  const glm::vec3 v = glm::cross(glm::normalize(view.normal), u);
  for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    scene.mesh.positions.push_back(view.position + corner.x * u + corner.y * v);
  scene.mesh.normals.assign(4, glm::vec3(0));
  scene.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.mesh.surface = {0, 0};
  scene.surfaces = {{"shading point", view.material}};
}

/// Looks at the point from the viewer's side; never quite along the surface.
Camera camera_for(const gen::View& view, float side) {
  glm::vec3 to_viewer = view.to_viewer;
  const float up = glm::dot(to_viewer, view.normal);
  if (up < 0.3F) to_viewer = glm::normalize(to_viewer + (0.3F - up) * view.normal);
  const glm::vec3 lift =
      std::abs(glm::dot(to_viewer, across(view.normal))) < 0.9F ? across(view.normal) : view.normal;
  return {view.position + 4 * side * to_viewer, view.position, lift, 45};
}

} // namespace

Scene scene_of_case(const oracle::Case& on, std::size_t view) {
  if (!on.triangles.empty()) return on.scene();
  Scene scene;
  scene.lights = on.light_set();
  scene.image_size = {320, 240};
  gen::View shown = on.views[view].view;
  shown.position = glm::clamp(shown.position, -farthest, farthest);
  const float side = half_side(on, shown.position);
  add_square(scene, shown, side);
  scene.camera = camera_for(shown, side);
  return scene;
}

} // namespace lightcuts::viz
