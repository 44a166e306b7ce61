// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts::oracle {

inline void add_quad(Scene& scene, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                     const glm::vec3& d) {
  const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
  scene.mesh.positions.insert(scene.mesh.positions.end(), {a, b, c, d});
  scene.mesh.normals.resize(scene.mesh.positions.size(), glm::vec3(0));
  scene.mesh.triangles.emplace_back(first, first + 1, first + 2);
  scene.mesh.triangles.emplace_back(first, first + 2, first + 3);
  scene.mesh.surface.resize(scene.mesh.triangles.size(), 0);
}

/// A square of half-width `half` at height y, facing up.
inline void add_level_square(Scene& scene, float half, float y) {
  add_quad(scene, {-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

/// A floor of 4 m x 4 m at y = 0 under lights at heights from 1 to 2 m, seen from above, filling
/// the 16 x 12 picture. Nothing occludes.
inline Scene floor_scene(std::uint32_t lights) {
  Scene scene;
  scene.name = "floor";
  scene.surfaces.push_back({"grey", {glm::vec3(0.5F), Phong{glm::vec3(0.2F), 20}}});
  add_level_square(scene, 2, 0);
  scene.camera = {{0, 3, 0.5F}, {0, 0, 0}, {0, 1, 0}, 30};
  scene.image_size = {16, 12};
  std::mt19937 random(1);
  const auto within = [&](float lo, float hi) {
    return lo + (hi - lo) * float(random() >> 8) * 0x1p-24F;
  };
  for (std::uint32_t i = 0; i < lights; ++i) {
    const float x = within(-2, 2), y = within(1, 2), z = within(-2, 2);
    scene.lights.add_omni({x, y, z}, glm::vec3(within(1, 3)));
  }
  return scene;
}

/// floor_scene() with a square of 1 m x 1 m hanging over the floor's middle, out of the camera's
/// way.
inline Scene shaded_floor_scene(std::uint32_t lights) {
  Scene scene = floor_scene(lights);
  add_quad(scene, {0.4F, 0.5F, 0.5F}, {1.4F, 0.5F, 0.5F}, {1.4F, 0.5F, -0.5F}, {0.4F, 0.5F, -0.5F});
  return scene;
}

} // namespace lightcuts::oracle
