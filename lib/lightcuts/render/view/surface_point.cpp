// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/surface_point.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <lightcuts/render/view/directed_rounding.h>

namespace lightcuts {
namespace {

struct Corners {
  glm::dvec3 a, b, c;
};

glm::dvec3 interpolate(const Corners& at, const glm::vec2& barycentric) {
  const double u = barycentric.x, v = barycentric.y;
  return at.a * (1 - u - v) + at.b * u + at.c * v;
}

// Turns n towards a viewer who looks along `view`.
glm::dvec3 facing(const glm::dvec3& n, const glm::dvec3& view) {
  return glm::dot(n, view) > 0 ? -n : n;
}

glm::dvec3 shading_normal(const TriangleMesh& mesh, const Hit& hit, const glm::dvec3& geometric,
                          const glm::dvec3& view) {
  if (mesh.normals.empty()) return geometric;
  const glm::uvec3 t = mesh.triangles[hit.triangle];
  const Corners at{mesh.normals[t.x], mesh.normals[t.y], mesh.normals[t.z]};
  const glm::dvec3 none(0);
  if (at.a == none || at.b == none || at.c == none) return geometric;
  glm::dvec3 n = interpolate(at, hit.barycentric);
  const double length = glm::length(n);
  // Unit normals carry a rounding of 2^-24: a sum below 2^-20 has no direction of its own.
  if (!(length > 0x1p-20)) return geometric;
  n /= length;
  if (glm::dot(n, geometric) < 0) n = -n;
  return glm::dot(n, view) < 0 ? n : geometric;
}

// How far off its plane a ray must start so that Embree cannot find the triangle at t >= 0.
//
// Embree takes the vertices relative to the origin, v = vertex - origin (each component off by
// u|v|, u = 2^-24), the edges e between them, a normal N = e x e', and asks for the sign of v.N.
// With L the longest edge and |v| <= V:
//   edges    |de| <= 2uV + uL
//   normal   |dN| <= 2L|de| + 2uL^2 <= 4uVL + 4uL^2
//   v.N      off by at most V|dN| + (1 + 3)uV|N| <= 4uV^2L + 8uVL^2
// An origin at height h has v.N = h|N|: the sign is right if h|N| > 12uL^3 for V = L. The factor 32
// leaves room for V up to 1.6 L. Absolute coordinates play no part, as the subtraction's inputs
// are exact. The height of a very thin triangle, |N|/L, counts as at least 2^-10 L.
double clearance(double longest, double normal_length) {
  const double height = std::max(normal_length / longest, 0x1p-10 * longest);
  return 32 * 0x1p-24 * longest * (longest / height);
}

} // namespace

SurfacePoint surface_point(const TriangleMesh& mesh, const Hit& hit,
                           const glm::vec3& view_direction) {
  const glm::uvec3 t = mesh.triangles[hit.triangle];
  const Corners at{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
  const glm::dvec3 view = glm::normalize(glm::dvec3(view_direction));
  const glm::dvec3 ab = at.b - at.a, ac = at.c - at.a;
  const double longest =
      std::max({glm::length(ab), glm::length(ac), glm::length(glm::dvec3(at.c - at.b))});
  const glm::dvec3 cross = glm::cross(ab, ac);
  const double area = glm::length(cross);

  const glm::dvec3 geometric = area > 0 ? facing(cross / area, view) : -view;
  const glm::dvec3 position = interpolate(at, hit.barycentric);
  const double height = longest > 0 ? clearance(longest, area) : 0;
  const glm::dvec3 off = position + height * geometric;
  // Each component is rounded away from the surface: the height is kept far from the origin, too.
  return {glm::vec3(position), glm::vec3(geometric),
          glm::vec3(shading_normal(mesh, hit, geometric, view)), rounded_towards(off, geometric)};
}

} // namespace lightcuts
