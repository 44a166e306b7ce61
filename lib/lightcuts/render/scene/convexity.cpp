// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/convexity.h>

#include <cmath>
#include <vector>

#include <lightcuts/core/geometry/box.h>

namespace lightcuts {
namespace {

/// Which side of the plane through a, b, c: -1, 1, or 0 for within rounding of it.
/// A point at infinity is given by its direction.
int side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p,
         bool at_infinity = false) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const glm::dvec3 w = at_infinity ? p : p - a;
  double determinant = 0;
  double magnitude = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    determinant += w[i] * (u[j] * v[k] - u[k] * v[j]);
    magnitude += std::abs(w[i]) * (std::abs(u[j] * v[k]) + std::abs(u[k] * v[j]));
  }
  // Fewer than 12 roundings of 2^-53, each of at most the sum of magnitudes.
  if (std::abs(determinant) <= 0x1p-49 * magnitude) return 0;
  return determinant > 0 ? 1 : -1;
}

std::vector<glm::dvec3> corners(const Box& box) {
  std::vector<glm::dvec3> result;
  for (int corner = 0; corner < 8; ++corner)
    result.emplace_back((corner & 1) != 0 ? box.hi.x : box.lo.x,
                        (corner & 2) != 0 ? box.hi.y : box.lo.y,
                        (corner & 4) != 0 ? box.hi.z : box.lo.z);
  return result;
}

/// What must not lie on both sides of a plane. Corners stand for the lights: a plane beside the box
/// is beside the lights.
struct PointsToTest {
  std::vector<glm::dvec3> points, at_infinity;

  PointsToTest(const TriangleMesh& mesh, const LightSet& lights, const glm::vec3& eye)
      : points{eye} {
    for (const glm::uvec3& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) points.emplace_back(mesh.positions[t[i]]);
    Box near = Box::empty(), far = Box::empty();
    for (const Light& light : lights)
      (is_at_infinity(light.kind) ? far : near).extend(light.position);
    if (near != Box::empty())
      for (const glm::dvec3& p : corners(near)) points.push_back(p);
    if (far != Box::empty()) at_infinity = corners(far);
  }
};

} // namespace

bool encloses_lights_convexly(const TriangleMesh& mesh, const LightSet& lights,
                              const glm::vec3& eye) {
  if (mesh.triangles.size() > 10000) return false;
  const PointsToTest test(mesh, lights, eye);
  for (const glm::uvec3& t : mesh.triangles) {
    bool below = false;
    bool above = false;
    const auto one_side = [&](const std::vector<glm::dvec3>& points, bool at_infinity) {
      for (const glm::dvec3& p : points) {
        const int s =
            side(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], p, at_infinity);
        below = below || s < 0;
        above = above || s > 0;
        if (below && above) return false;
      }
      return true;
    };
    if (!one_side(test.points, false) || !one_side(test.at_infinity, true)) return false;
  }
  return true;
}

} // namespace lightcuts
