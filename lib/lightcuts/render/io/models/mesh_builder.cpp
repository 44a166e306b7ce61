// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/mesh_builder.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

/// Appends to a list that is empty, or as long as the positions before the new one.
template <class Value>
void put(std::vector<Value>& list, const std::optional<Value>& value, const Value& otherwise,
         std::size_t before) {
  if (!value && list.empty()) return;
  list.resize(before, otherwise);
  list.push_back(value.value_or(otherwise));
}

} // namespace

MeshBuilder::MeshBuilder(std::string file, Scene& scene)
    : file_(std::move(file)), scene_(scene), first_triangle_(scene.mesh.triangles.size()) {}

std::uint32_t MeshBuilder::add(const MeshVertex& vertex) {
  TriangleMesh& mesh = scene_.mesh;
  const std::size_t index = mesh.positions.size();
  if (index >= most || mesh.triangles.size() >= most)
    throw InputError(InputFault::too_large,
                     fmt::format("{}: more than {} vertices or triangles", file_, most));
  mesh.positions.push_back(vertex.position);
  mesh.normals.push_back(vertex.normal);
  put(mesh.uv, vertex.uv, glm::vec2(0), index);
  put(mesh.emission_uv, vertex.emission_uv, glm::vec2(0), index);
  put(mesh.colours, vertex.colour, glm::vec3(1), index);
  return static_cast<std::uint32_t>(index);
}

void MeshBuilder::add_triangle(const glm::uvec3& corners, std::uint32_t surface) {
  const auto& positions = scene_.mesh.positions;
  const glm::dvec3 a(positions[corners.x]);
  const glm::dvec3 ab = glm::dvec3(positions[corners.y]) - a;
  const glm::dvec3 ac = glm::dvec3(positions[corners.z]) - a;
  if (glm::cross(ab, ac) == glm::dvec3(0)) {
    ++without_area_;
    return;
  }
  scene_.mesh.triangles.push_back(corners);
  scene_.mesh.surface.push_back(surface);
}

void MeshBuilder::finish() {
  if (scene_.mesh.triangles.size() == first_triangle_)
    throw InputError(InputFault::missing, fmt::format("{}: no triangles", file_));
  if (without_area_ > 0)
    scene_.notes.push_back(
        fmt::format("{}: {} without area left out", file_, counted(without_area_, "triangle")));
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  const glm::vec3 result(length > 0 ? v / length : glm::dvec3(0));
  return is_finite(result) ? result : glm::vec3(0);
}

} // namespace lightcuts
