// SPDX-License-Identifier: MIT
#include <viz/gl/scene/scene_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/bounds.h>

namespace lightcuts::viz {
namespace {

struct Vertex {
  glm::vec3 position, normal, face;
  glm::vec2 uv;
};
static_assert(sizeof(Vertex) == 44);

glm::vec3 face_normal(const TriangleMesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  const glm::dvec3 cross = glm::cross(b - a, c - a);
  const double area = glm::length(cross);
  return area > 0 ? glm::vec3(cross / area) : glm::vec3(0);
}

bool has_normals(const TriangleMesh& mesh, const glm::uvec3& t) {
  if (mesh.normals.empty()) return false;
  const glm::vec3 none(0);
  return mesh.normals[t.x] != none && mesh.normals[t.y] != none && mesh.normals[t.z] != none;
}

void append(const TriangleMesh& mesh, std::uint32_t triangle, const glm::dvec3& anchor,
            std::vector<Vertex>& vertices) {
  const glm::uvec3 t = mesh.triangles[triangle];
  const glm::vec3 face = face_normal(mesh, t);
  const bool smooth = has_normals(mesh, t);
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t i = t[corner];
    vertices.push_back({glm::vec3(glm::dvec3(mesh.positions[i]) - anchor),
                        smooth ? mesh.normals[i] : glm::vec3(0), face,
                        mesh.uv.empty() ? glm::vec2(0) : mesh.uv[i]});
  }
}

std::vector<std::uint32_t> sorted_by_surface(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.surface[a] < mesh.surface[b];
  });
  return order;
}

glm::dvec3 centre(const Box& box) {
  if (box.lo.x > box.hi.x) return glm::dvec3(0);
  return 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
}

} // namespace

SceneMesh::SceneMesh(const Scene& scene)
    : bounds_(scene_bounds(scene.mesh)), anchor_(centre(bounds_)) {
  const TriangleMesh& mesh = scene.mesh;
  if (mesh.triangles.size() > std::numeric_limits<GLsizei>::max() / 3)
    throw InputError(InputFault::too_large, "too many triangles to draw");
  std::vector<Vertex> vertices;
  vertices.reserve(3 * mesh.triangles.size());
  for (const std::uint32_t triangle : sorted_by_surface(mesh)) {
    const std::uint32_t surface = mesh.surface[triangle];
    if (ranges_.empty() || ranges_.back().surface != surface)
      ranges_.push_back({surface, GLint(vertices.size()), 0});
    append(mesh, triangle, anchor_, vertices);
    ranges_.back().count += 3;
  }
  layout_.bind();
  vertices_.upload(GL_ARRAY_BUFFER, std::span<const Vertex>(vertices), GL_STATIC_DRAW);
  const auto attribute = [&](GLuint index, int components, std::size_t offset) {
    layout_.attribute(index, vertices_, components, GL_FLOAT, false, sizeof(Vertex), offset);
  };
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 3, offsetof(Vertex, face));
  attribute(3, 2, offsetof(Vertex, uv));
}

void SceneMesh::draw(const Range& range) const {
  layout_.bind();
  glDrawArrays(GL_TRIANGLES, range.first, range.count);
}

} // namespace lightcuts::viz
