// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/triangle_tree.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#include <lightcuts/render/view/occluder.h>

namespace lightcuts {
namespace {

constexpr std::uint32_t most_in_leaf = 2;

std::optional<FlatTriangle> flat_triangle(const TriangleMesh& mesh, const glm::uvec3& t,
                                          double extent) {
  if (blocks_nothing(mesh, t)) return std::nullopt;
  FlatTriangle flat{};
  flat.corners = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
  auto& [a, b, c] = flat.corners;
  const auto longest_last = [&] {
    return glm::distance(a, b) >= glm::distance(b, c) && glm::distance(a, b) >= glm::distance(c, a);
  };
  for (int turn = 0; turn < 2 && !longest_last(); ++turn)
    std::rotate(flat.corners.begin(), flat.corners.begin() + 1, flat.corners.end());
  const glm::dvec3 cross = glm::cross(b - a, c - a);
  const double area = glm::length(cross);
  flat.normal = cross / area;
  flat.longest = glm::distance(a, b);
  flat.slimness = flat.longest * flat.longest / area;
  // Products of a few edges, relative to the mesh, have to stay far above 2^-126.
  if (area < 0x1p-60 * extent * extent) flat.slimness = std::numeric_limits<double>::infinity();
  return flat;
}

glm::dvec3 middle(const FlatTriangle& t) {
  return (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0;
}

std::tuple<double, double, double> in_order(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Box box_of(std::span<const FlatTriangle> triangles) {
  Box box = Box::empty();
  for (const FlatTriangle& t : triangles)
    for (const glm::dvec3& p : t.corners) box.extend(glm::vec3(p)); // a float it is
  return box;
}

} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  double extent = 0;
  for (const glm::vec3& p : mesh.positions) {
    box_.extend(p);
    for (int c = 0; c < 3; ++c) extent = std::max(extent, std::abs(double(p[c])));
  }
  for (const glm::uvec3& t : mesh.triangles)
    if (const auto flat = flat_triangle(mesh, t, extent)) triangles_.push_back(*flat);
  if (triangles_.empty()) return;
  nodes_.resize(1);
  split(0, 0, std::uint32_t(triangles_.size()));
  pair_up();
}

void TriangleTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  const std::span own = std::span(triangles_).subspan(first, count);
  nodes_[node] = {box_of(own), first, count};
  if (count <= most_in_leaf) return;
  const glm::vec3 extent = nodes_[node].box.hi - nodes_[node].box.lo;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  std::stable_sort(own.begin(), own.end(), [axis](const FlatTriangle& a, const FlatTriangle& b) {
    return middle(a)[axis] < middle(b)[axis];
  });
  const auto child = std::uint32_t(nodes_.size());
  nodes_[node].first = child;
  nodes_[node].count = 0;
  nodes_.resize(nodes_.size() + 2);
  split(child, first, half);
  split(child + 1, first + half, count - half);
}

void TriangleTree::pair_up() {
  using Corner = std::tuple<double, double, double>;
  std::map<std::pair<Corner, Corner>, std::uint32_t> by_edge;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    FlatTriangle& t = triangles_[i];
    t.partner = i;
    auto edge = std::pair(in_order(t.corners[0]), in_order(t.corners[1]));
    if (edge.second < edge.first) std::swap(edge.first, edge.second);
    const auto [found, is_first] = by_edge.try_emplace(edge, i);
    if (is_first) continue;
    FlatTriangle& other = triangles_[found->second];
    if (other.partner != found->second) continue; // it has one
    t.partner = found->second;
    other.partner = i;
  }
}

} // namespace lightcuts
