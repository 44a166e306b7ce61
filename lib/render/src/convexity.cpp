// SPDX-License-Identifier: MIT
#include <lightcuts/render/convexity.h>

#include <cmath>
#include <vector>

#include <lightcuts/box.h>

namespace lightcuts {
namespace {

/// Which side of the plane through a, b, c: -1, 1, or 0 for within rounding of it.
int side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  const glm::dvec3 w = p - a;
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

/// Corners stand for the lights: a plane beside the box is beside the lights.
std::vector<glm::dvec3> points_to_test(const TriangleMesh& mesh, const LightSet& lights,
                                       const glm::vec3& eye) {
  std::vector<glm::dvec3> points{eye};
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) points.emplace_back(mesh.positions[t[i]]);
  Box box = Box::empty();
  for (const OmniLight& light : lights) box.extend(light.position);
  for (int corner = 0; corner < 8 && !lights.empty(); ++corner)
    points.emplace_back((corner & 1) != 0 ? box.hi.x : box.lo.x,
                        (corner & 2) != 0 ? box.hi.y : box.lo.y,
                        (corner & 4) != 0 ? box.hi.z : box.lo.z);
  return points;
}

} // namespace

bool encloses_lights_convexly(const TriangleMesh& mesh, const LightSet& lights,
                              const glm::vec3& eye) {
  if (mesh.triangles.size() > 10000) return false;
  const std::vector<glm::dvec3> points = points_to_test(mesh, lights, eye);
  for (const glm::uvec3& t : mesh.triangles) {
    bool below = false;
    bool above = false;
    for (const glm::dvec3& p : points) {
      const int s = side(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], p);
      below = below || s < 0;
      above = above || s > 0;
      if (below && above) return false;
    }
  }
  return true;
}

} // namespace lightcuts
