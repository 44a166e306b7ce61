// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// A triangle of a mesh in double, so that no area over- or underflows. Metres.
struct Triangle {
  Triangle(const TriangleMesh& mesh, std::size_t index)
      : a(mesh.positions[mesh.triangles[index].x]), b(mesh.positions[mesh.triangles[index].y]),
        c(mesh.positions[mesh.triangles[index].z]) {}

  [[nodiscard]] double area() const { return 0.5 * glm::length(glm::cross(b - a, c - a)); }
  /// Unit; towards where the corners run counter-clockwise. The area must not be 0.
  [[nodiscard]] glm::dvec3 normal() const { return glm::normalize(glm::cross(b - a, c - a)); }
  /// The point with these weights of b and c.
  [[nodiscard]] glm::dvec3 at(const glm::dvec2& barycentric) const {
    return a * (1 - barycentric.x - barycentric.y) + b * barycentric.x + c * barycentric.y;
  }

  glm::dvec3 a, b, c;
};

/// Maps the unit square to a triangle's barycentric coordinates: equal areas to equal areas.
inline glm::dvec2 square_to_triangle(const glm::dvec2& u) {
  const double s = std::sqrt(u.x);
  return {1 - s, u.y * s};
}

} // namespace lightcuts
