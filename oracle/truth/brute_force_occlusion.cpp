// SPDX-License-Identifier: MIT
#include <oracle/truth/brute_force_occlusion.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

// The test: with v the vertices relative to the ray's origin, D its direction and e = v_j - v_i,
//   edge function   U = (e x s).D,  s = v_i + v_j    inside if all three have one sign
//   normal          N = e x e'
//   distance        t = v.N / D.N                    met if 0 <= t <= far
// In single precision, u = 2^-24, |.| and the comparisons per component,
// (a (x) b)_x = a_y b_z + a_z b_y:
//   v_i    off by u|v_i|
//   e, s   off by 2u w,  w = |v_i| + |v_j|
//   U      = e.(s x D), off by 2u w.|s x D| for e and, with e' = |e| + 2u w, by 9u |D|.(e' (x) w):
//          2u for s, 1 product, 1 difference, 1 product, 2 sums; 2u to spare.
// Embree accepts 2^-23 |U + V + W| on the wrong side: 2u (|U| + |V| + |W|) more.
//   N      e off by 2u m + uE,  m = max |v_i|,  E = max |e| + 4u m,  hence off by
//          4u G + 8u E (x) E / 2 <= 12u G,  G = E (x) m,  as E <= 2m
//   D.N    off by (12u G + 3u |N'|).|D|,  |N'| <= |N| + 12u G
//   v.N    with t exact and x = v - t D, which N is normal to, v.N - t D.N is off by
//          12u G.|x| + 4u |N'|.|v| + 3u |N'|.|t D|
//   t      is that over the least D.N, and another 4u, relative, for reciprocal and product.
// The constants below leave a factor of 1.5 and more for higher orders, another order of the sums
// and our own rounding, 2^-53.
constexpr double u = 0x1p-24;
constexpr double edge_margin = 16 * u, direction_margin = 4 * u, tolerance_margin = 4 * u;
constexpr double normal_margin = 20 * u, product_margin = 8 * u, quotient_margin = 8 * u;

// With the mesh scaled to [1, 2) by a power of two and D likewise, as Occluder does it, a
// subnormal product or input is off by less than 2^-122. Where the terms of a formula stay below
// this floor, the margins above are taken from the floor instead, and cover that, too.
constexpr double underflow_floor = 0x1p-96;
// Beyond this ratio of scales single precision may overflow.
constexpr double overflow_ratio = 0x1p40;

// a_y b_z + a_z b_y and so on: the cross product of magnitudes.
glm::dvec3 magnitude_cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double power_below(double x) { return x > 0 ? std::ldexp(1.0, std::ilogb(x)) : 1.0; }

// The ray in units of the scene: a direction in [1, 2), a reach in scene sizes.
struct UnitRay {
  glm::dvec3 origin, direction;
  double far;
};

// At least the margin of line_meets(), for all triangles with |v| <= m: with W = 2 m in place of
// each component of w and e, |D| < 2 and |s x D| <= 4 W, the three terms are at most 16u 12.2 W^2,
// 4u 12 W^2 and 4u 36 W^2.
double largest_margin(double m) {
  const double w = 2 * m;
  return 512 * u * (w * w + underflow_floor);
}

double edge_value(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& d) {
  return glm::dot(q - p, glm::cross(p + q, d));
}

// Whether the line passes the triangle by so far that no rounding matters: most of them.
bool line_misses(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                 double margin) {
  const double ab = edge_value(a, b, d), bc = edge_value(b, c, d);
  if (ab > margin ? bc < -margin : ab < -margin && bc > margin) return true;
  const double ca = edge_value(c, a, d);
  return std::min({ab, bc, ca}) < -margin && std::max({ab, bc, ca}) > margin;
}

struct EdgeFunction {
  double value, margin;
};

EdgeFunction edge_function(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& d) {
  const glm::dvec3 e = q - p, turn = glm::cross(p + q, d);
  const glm::dvec3 w = glm::abs(p) + glm::abs(q);
  const double terms = glm::dot(glm::abs(d), magnitude_cross(glm::abs(e) + 2 * u * w, w));
  return {glm::dot(e, turn), edge_margin * std::max(terms, underflow_floor) +
                                 direction_margin * glm::dot(w, glm::abs(turn))};
}

// Whether the line meets the triangle's inside: `blocked` for yes.
Occlusion line_meets(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                     const glm::dvec3& d) {
  const auto ab = edge_function(a, b, d), bc = edge_function(b, c, d), ca = edge_function(c, a, d);
  const double tolerance =
      tolerance_margin * (std::abs(ab.value) + std::abs(bc.value) + std::abs(ca.value));
  const double margin = std::max({ab.margin, bc.margin, ca.margin}) + tolerance;
  const double low = std::min({ab.value, bc.value, ca.value});
  const double high = std::max({ab.value, bc.value, ca.value});
  if (low > margin || high < -margin) return Occlusion::blocked;
  if (low < -margin && high > margin) return Occlusion::clear;
  return Occlusion::undecided;
}

// Whether the segment reaches across the triangle's plane: `blocked` for yes.
Occlusion segment_crosses(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                          const glm::dvec3& d, double far) {
  const glm::dvec3 m = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
  const glm::dvec3 e = glm::max(glm::max(glm::abs(b - a), glm::abs(c - a)), glm::abs(c - b));
  const glm::dvec3 off = normal_margin * magnitude_cross(e + 4 * u * m, m);
  const glm::dvec3 normal = glm::cross(b - a, c - a), size = glm::abs(normal) + off;
  const double floor = normal_margin * underflow_floor * (1 + largest(m));

  const double slope = glm::dot(normal, d), offset = glm::dot(a, normal);
  const double gentlest =
      std::abs(slope) - glm::dot(off + product_margin * size, glm::abs(d)) - floor;
  if (gentlest <= 0) return Occlusion::undecided;
  const double t = offset / slope;
  const double residue = glm::dot(off, glm::abs(a - t * d)) +
                         product_margin * glm::dot(size, glm::abs(a) + std::abs(t) * glm::abs(d)) +
                         floor;
  const double margin = residue / gentlest + quotient_margin * std::abs(t);
  if (t + margin < 0 || t - margin > far) return Occlusion::clear;
  return t - margin > 0 && t + margin < far ? Occlusion::blocked : Occlusion::undecided;
}

Occlusion triangle_occlusion(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                             const UnitRay& ray) {
  if (a == b || b == c || c == a) return Occlusion::clear; // no area
  const Occlusion line = line_meets(a, b, c, ray.direction);
  if (line == Occlusion::clear) return line;
  const Occlusion segment = segment_crosses(a, b, c, ray.direction, ray.far);
  if (segment == Occlusion::clear) return segment;
  return line == segment ? line : Occlusion::undecided;
}

} // namespace

Occlusion brute_force_occlusion(const TriangleMesh& mesh, const ShadowRay& ray) {
  if (mesh.triangles.empty() || ray.direction == glm::vec3(0)) return Occlusion::clear;
  glm::dvec3 extreme(0);
  for (const glm::vec3& p : mesh.positions) extreme = glm::max(extreme, glm::dvec3(glm::abs(p)));
  const double size = power_below(largest(extreme));
  const double length = power_below(largest(glm::dvec3(ray.direction)));
  const UnitRay unit{glm::dvec3(ray.origin) / size, glm::dvec3(ray.direction) / length,
                     ray.far * (length / size)};
  if (largest(unit.origin) > overflow_ratio) return Occlusion::undecided;
  if (unit.far < 1 / overflow_ratio || unit.far > overflow_ratio) return Occlusion::undecided;

  std::vector<glm::dvec3> vertices;
  vertices.reserve(mesh.positions.size());
  double farthest = 0;
  for (const glm::vec3& p : mesh.positions) {
    vertices.push_back(glm::dvec3(p) / size - unit.origin);
    farthest = std::max(farthest, largest(vertices.back()));
  }
  const double margin = largest_margin(farthest);

  Occlusion result = Occlusion::clear;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
    if (line_misses(a, b, c, unit.direction, margin)) continue;
    const Occlusion one = triangle_occlusion(a, b, c, unit);
    if (one == Occlusion::blocked) return one;
    if (one == Occlusion::undecided) result = one;
  }
  return result;
}

} // namespace lightcuts
