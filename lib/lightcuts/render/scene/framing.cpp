// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/framing.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <lightcuts/render/scene/bounds.h>

namespace lightcuts {
namespace {

constexpr int rays_per_side = 8;
constexpr std::size_t most_tested = 20000; // triangles; more are thinned out
constexpr double preference = 1.5;         // how much deeper another view must see

struct View {
  glm::dvec3 forward, right, up;
};

View view_along(const glm::dvec3& direction) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  return {forward, right, glm::cross(right, forward)};
}

/// Distance along the ray to the triangle; infinite where it misses (Moeller and Trumbore 1997).
double hit(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
           const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 p = glm::cross(direction, c - a);
  const double determinant = glm::dot(b - a, p);
  if (determinant == 0) return INFINITY;
  const double u = glm::dot(origin - a, p) / determinant;
  const glm::dvec3 q = glm::cross(origin - a, b - a);
  const double v = glm::dot(direction, q) / determinant;
  const double t = glm::dot(c - a, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? t : INFINITY;
}

/// Where the ray enters the box; infinite where it misses.
double entry(const glm::dvec3& origin, const glm::dvec3& direction, const Box& box) {
  double near = 0, far = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const double one = (box.lo[axis] - origin[axis]) / direction[axis];
    const double other = (box.hi[axis] - origin[axis]) / direction[axis];
    near = std::max(near, std::min(one, other));
    far = std::min(far, std::max(one, other));
  }
  return near <= far ? near : INFINITY;
}

double first_hit(const TriangleMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction) {
  const std::size_t stride = mesh.triangles.size() / most_tested + 1;
  double nearest = INFINITY;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += stride) {
    const glm::uvec3& t = mesh.triangles[i];
    nearest = std::min(nearest, hit(origin, direction, mesh.positions[t.x], mesh.positions[t.y],
                                    mesh.positions[t.z]));
  }
  return nearest;
}

/// How deep inside the box the view's parallel rays end, in the mean; what flies through counts 0.
double depth_seen(const TriangleMesh& mesh, const Box& box, const View& view) {
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  const double diagonal = diagonal_length(box);
  double sum = 0;
  int entered = 0;
  for (int i = 0; i < rays_per_side * rays_per_side; ++i) {
    const int row = i / rays_per_side, column = i % rays_per_side;
    const double x = (column + 0.5) / rays_per_side - 0.5, y = (row + 0.5) / rays_per_side - 0.5;
    const glm::dvec3 origin = centre + diagonal * (x * view.right + y * view.up - view.forward);
    const double start = entry(origin, view.forward, box);
    if (std::isinf(start)) continue;
    ++entered;
    const double end = first_hit(mesh, origin, view.forward);
    if (!std::isinf(end)) sum += std::max(0.0, end - start);
  }
  return entered > 0 ? sum / entered : 0;
}

View best_view(const TriangleMesh& mesh, const Box& box) {
  View best = view_along({-0.6, -0.5, -1});
  double deepest = preference * depth_seen(mesh, box, best);
  for (const glm::dvec3& axis :
       {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0), glm::dvec3(1, 0, 0)}) {
    const View view = view_along(axis);
    const double depth = depth_seen(mesh, box, view);
    if (depth > deepest) {
      best = view;
      deepest = depth;
    }
  }
  return best;
}

} // namespace

Camera framing(const TriangleMesh& mesh) {
  const Box box = scene_bounds(mesh);
  const View view = best_view(mesh, box);
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  constexpr double tangent = 0.41421356237309505; // of half of 45 degrees
  constexpr double aspect = 4.0 / 3, air = 1.05;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p =
        glm::dvec3(corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                   corner & 4 ? box.hi.z : box.lo.z) -
        centre;
    const double reach =
        std::max(std::abs(glm::dot(p, view.up)), std::abs(glm::dot(p, view.right)) / aspect) /
        tangent;
    distance = std::max(distance, air * reach - glm::dot(p, view.forward));
  }
  return {glm::vec3(centre - distance * view.forward), glm::vec3(centre), {0, 1, 0}, 45};
}

} // namespace lightcuts
