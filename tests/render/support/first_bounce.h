// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts::test {

/// Irradiance of a point x with normal n in an empty closed_box of white walls, from the light of
/// an omni light of intensity 1 at y that the walls reflect once: the midpoint rule over them.
inline double first_bounce(const glm::dvec3& size, const glm::dvec3& y, const glm::dvec3& x,
                           const glm::dvec3& n) {
  constexpr int cells = 100;
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (int wall = 0; wall < 6; ++wall) {
    const int axis = wall / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dvec3 inward(0), p(0);
    inward[axis] = wall % 2 == 0 ? 1 : -1;
    p[axis] = wall % 2 == 0 ? 0 : size[axis];
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < cells; ++k) {
        p[u] = (i + 0.5) / cells * size[u];
        p[v] = (k + 0.5) / cells * size[v];
        const glm::dvec3 from = y - p, to = x - p;
        const double d2 = glm::dot(from, from), e2 = glm::dot(to, to);
        const double irradiance = glm::dot(inward, from) / (d2 * std::sqrt(d2));
        const double area = size[u] * size[v] / (cells * cells);
        sum += area * irradiance / pi * std::max(0.0, glm::dot(inward, to)) *
               std::max(0.0, -glm::dot(n, to)) / (e2 * e2);
      }
  }
  return sum;
}

/// Irradiance from the lights [first, end) where nothing occludes, by the library; red.
inline double irradiance(const LightSet& lights, std::size_t first, const glm::vec3& x,
                         const glm::vec3& n) {
  LightSet part;
  for (std::size_t i = first; i < lights.size(); ++i) part.add(lights[i]);
  const ShadingPoint white(x, n, n, {.diffuse = glm::vec3(1)});
  return 3.14159265358979323846 *
         sum_lights(part, white, [](std::uint32_t) { return true; }).radiance.x;
}

/// Relative root mean square error of that over points away from the walls of a white box with an
/// omni light of intensity 1 at y, against first_bounce.
inline double first_bounce_error(const Scene& scene, const glm::vec3& size, const glm::vec3& y) {
  double errors = 0, truths = 0;
  for (const glm::vec3& n : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0.6F, 0, 0.8F)})
    for (const float t : {0.3F, 0.5F, 0.6F, 0.7F}) {
      const glm::vec3 x = size * glm::vec3(t, 0.5F, 1 - t);
      const double truth = first_bounce(size, y, x, n);
      const double error = irradiance(scene.lights, 1, x, n) - truth;
      errors += error * error;
      truths += truth * truth;
    }
  return std::sqrt(errors / truths);
}

} // namespace lightcuts::test
