// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts::test {

/// Adds the quadrilateral of one surface, counter-clockwise seen from its front.
inline void add_quad(Scene& scene, std::uint32_t surface, const glm::vec3& a, const glm::vec3& b,
                     const glm::vec3& c, const glm::vec3& d) {
  const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
  for (const glm::vec3& p : {a, b, c, d}) {
    scene.mesh.positions.push_back(p);
    scene.mesh.normals.emplace_back(0);
  }
  scene.mesh.triangles.emplace_back(first, first + 1, first + 2);
  scene.mesh.triangles.emplace_back(first, first + 2, first + 3);
  scene.mesh.surface.insert(scene.mesh.surface.end(), 2, surface);
}

inline std::uint32_t add_surface(Scene& scene, const glm::vec3& diffuse,
                                 const glm::vec3& emission = glm::vec3(0)) {
  Surface surface;
  surface.name = "surface";
  surface.material.diffuse = diffuse;
  surface.emission = emission;
  scene.surfaces.push_back(surface);
  return static_cast<std::uint32_t>(scene.surfaces.size() - 1);
}

/// A closed box from 0 to `size` of one diffuse surface, the fronts of its walls inside.
inline Scene closed_box(const glm::vec3& size, const glm::vec3& diffuse) {
  Scene scene;
  const std::uint32_t wall = add_surface(scene, diffuse);
  const auto corner = [&](int x, int y, int z) {
    return size * glm::vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  add_quad(scene, wall, corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0));
  add_quad(scene, wall, corner(0, 1, 0), corner(1, 1, 0), corner(1, 1, 1), corner(0, 1, 1));
  add_quad(scene, wall, corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0));
  add_quad(scene, wall, corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1), corner(1, 0, 1));
  add_quad(scene, wall, corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1));
  add_quad(scene, wall, corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 1), corner(1, 1, 0));
  scene.camera = {0.5F * size, {0.5F * size.x, 0.5F * size.y, 0}, {0, 1, 0}, 90};
  return scene;
}

/// A square metre that faces up, y = 0, black to the left (-x) and white to the right, 50 % in the
/// mean.
inline Scene textured_square() {
  Scene scene;
  const std::uint32_t surface = add_surface(scene, glm::vec3(1));
  add_quad(scene, surface, {-0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, -0.5F});
  scene.mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.textures.emplace_back(glm::uvec2(2, 1), std::vector{glm::vec3(0), glm::vec3(1)});
  scene.surfaces[surface].texture = SurfaceTexture{0, {Wrap::clamp, Wrap::clamp}};
  return scene;
}

/// Sum of the intensities of the lights from `first` on, times pi: the power of oriented ones, W.
inline glm::dvec3 oriented_power(const LightSet& lights, std::size_t first = 0) {
  glm::dvec3 sum(0);
  for (std::size_t i = first; i < lights.size(); ++i) sum += glm::dvec3(lights[i].intensity);
  return 3.14159265358979323846 * sum;
}

/// A closed room around an omni light.
inline const glm::vec3 room_size(2, 3, 4); // 52 m^2 of wall
inline const glm::vec3 lamp_position(0.7F, 2, 1.5F);
inline Scene lit_room(const glm::vec3& reflectance, const glm::vec3& intensity = glm::vec3(1)) {
  Scene scene = closed_box(room_size, reflectance);
  scene.lights.add_omni(lamp_position, intensity);
  return scene;
}

inline bool same_bits(const LightSet& a, const LightSet& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

} // namespace lightcuts::test
