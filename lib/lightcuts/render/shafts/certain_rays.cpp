// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/certain_rays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

// Embree's robust test of a ray from o along d against a triangle, u = 2^-24: it takes the corners
// relative to o, of length V at most (off by u per component), edges e, sums s of two corners,
//   edge functions  U = (e x s).d       of one sign, or wrong by 2u |U + U' + U''|
//   normal          N = e x e'          distance  t = v.N / d.N, met if 0 <= t <= far.
// With E the longest edge, h the height over it, A = E / h, f the angle of ray and plane, and V no
// less than |d|:
//   U     after the corners have been rounded, off by 7u sqrt 2 |e| 2V |d|, with the tolerance by
//         28u V |e| |d|; as U = 2 |d| sin f x (twice the area of e and where the line meets the
//         plane), the line meets the plane within k = 14u V / sin f of the inner side of each edge,
//         or of the outer: within 4k A of the triangle
//   t     N is off by 6u E^2: |d| t by 22u V A / sin f
// so that a ray that is taken for blocked has a point within
//   r = 84u V A / sin f                                                                        (1)
// of the triangle, 2u V for rounding corners and d among it. That turns the plane by 4u V / h at
// most: for sin f >= 16u V / h, 160u V A / sin f holds for the true f and A.
//   heights  of the ray's ends above the plane, out of v.N and d.N: off by
//            m = u V (8 V / h + 8 A + 8)                                                       (2)
constexpr double u = 0x1p-24;
constexpr double nearness = 160 * u, turning = 16 * u;

double plane_margin(const FlatTriangle& t, double v) {
  return 8 * u * v * (v * t.slimness / t.longest + t.slimness + 1);
}

/// By (1): a triangle that is so far from a ray is missed where sin f is at least this.
double safe_sine(const FlatTriangle& t, double v, double separation) {
  return v * t.slimness * (nearness / separation + turning / t.longest);
}

/// Where a ray that is so far from a triangle is taken for blocked, sin f is at most 112u V A / it
/// by (1), A of the rounded corners being a third larger at most, for h >= 16u V. It meets the
/// plane, within the 30u V A by which t is off, between its ends: its start is this close to the
/// plane, and its end within twice as much.
double edge_on_margin(const FlatTriangle& t, double v, double separation) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(t.longest >= 16 * u * v * t.slimness)) return infinity;
  return u * v * t.slimness * (112 * v / separation + 30) + plane_margin(t, v);
}

struct Range {
  double lo, hi;

  void include(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  [[nodiscard]] Range negated() const { return {-hi, -lo}; }
  /// Least magnitude.
  [[nodiscard]] double least() const { return lo > 0 ? lo : hi < 0 ? -hi : 0; }
};

/// Of n.(p - base) over the box.
Range range_over(const Box& box, const glm::dvec3& n, const glm::dvec3& base) {
  const glm::dvec3 lo = (glm::dvec3(box.lo) - base) * n, hi = (glm::dvec3(box.hi) - base) * n;
  const glm::dvec3 least = glm::min(lo, hi), most = glm::max(lo, hi);
  return {least.x + least.y + least.z, most.x + most.y + most.z};
}

Range heights(const FlatTriangle& t, const Box& box) {
  return range_over(box, t.normal, t.corners[0]);
}

Range heights(const FlatTriangle& t, const std::vector<glm::dvec3>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range{infinity, -infinity};
  for (const glm::dvec3& p : points) range.include(t.height(p));
  return range;
}

/// What holds on one side of the plane, x the heights of the rays' starts, y those of their ends.
bool is_missed_above(const FlatTriangle& t, const Range& x, const Range& y, double v,
                     double longest) {
  // Both ends are above: T or T' alone decides that t is below 0 or above far.
  if (const double m = 4 * plane_margin(t, v); x.lo > m && y.lo > m) return true;
  // Rays that leave the plane at an angle whose sine is s: v.N is off by
  // 4u V^2 E + 8u V E^2 (see surface_point()), so that its sign is right for V <= 1.75 E and T of
  // 28u E A or more, and t < 0. Where the triangle is farther than g = 0.75 E from the start, V is
  // at most 2.4 g, and the ray stays g s / 2 away from it; by (1) it is missed for s^2 >= 2^-13 A,
  // t, which is -T / s, being off by 9u A g / s^2 more: s^3 >= 2^-19 A.
  const double rise = y.lo - x.hi;
  if (rise > 0 && x.lo >= 28 * u * t.longest * t.slimness) {
    const double sine = rise / longest;
    if (sine * sine >= 0x1p-13 * t.slimness && sine * sine * sine >= 0x1p-19 * t.slimness)
      return true;
  }
  // Lights on the plane: a ray that ends above, or no more than 2^-16 of its fall below, meets it
  // at t >= 1 - 2^-16, 2^-14 + 2^-16 beyond far; by (1) t is off by 30u V A / fall.
  const double fall = x.lo - y.hi;
  return y.lo >= -0x1p-16 * fall && fall >= 0x1p-4 * t.slimness * v &&
         fall >= 128 * u * v * v * t.slimness / t.longest;
}

/// Unit vectors at right angles, the third where points extend least, so that the rectangle
/// around them in the plane of the others is small: along one of the ways from the first point.
std::array<glm::dvec3, 3> axes_of(std::span<const glm::dvec3> points) {
  const auto farthest = [&](auto&& way_to) {
    glm::dvec3 most(0);
    for (const glm::dvec3& p : points)
      if (const glm::dvec3 way = way_to(p - points.front()); glm::length(way) > glm::length(most))
        most = way;
    return most;
  };
  const glm::dvec3 first = farthest([](const glm::dvec3& way) { return way; });
  if (!(glm::length(first) > 0)) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const glm::dvec3 along = glm::normalize(first);
  const glm::dvec3 aside =
      farthest([&](const glm::dvec3& way) { return way - along * glm::dot(along, way); });
  const glm::dvec3 least = std::abs(along.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const bool on_a_line = !(glm::length(aside) > 0x1p-20 * glm::length(first));
  const glm::dvec3 up = glm::normalize(glm::cross(along, on_a_line ? least : aside));

  std::array<glm::dvec3, 3> best{};
  double smallest = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points) {
    const glm::dvec3 flat = p - points.front() - up * glm::dot(up, p - points.front());
    if (!(glm::length(flat) > 0x1p-20 * glm::length(first))) continue;
    const glm::dvec3 a = glm::normalize(flat), b = glm::cross(up, a);
    Range in_a{0, 0}, in_b{0, 0};
    for (const glm::dvec3& q : points) {
      in_a.include(glm::dot(a, q - points.front()));
      in_b.include(glm::dot(b, q - points.front()));
    }
    const double area = (in_a.hi - in_a.lo) * (in_b.hi - in_b.lo);
    if (!(area < smallest)) continue;
    smallest = area;
    best = {a, b, up};
  }
  return best;
}

/// det(a - x, b - x, y - x) over all starts x and ends y: linear in x and in y, so that the corners
/// of their boxes decide. It is half an edge function, which rounding the corners makes off by
/// 3.5u V^2 |d|, its formula by 20u V^2 |d|, rounding d by 4u V^2 |d|, and the tolerance by 8u.
Range edge_range(const glm::dvec3& a, const glm::dvec3& b, const RayEnds& ends) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range{infinity, -infinity};
  for (const glm::dvec3& x : ends.corners) {
    const Range at_x = range_over(ends.to, glm::cross(a - x, b - x), x);
    range.lo = std::min(range.lo, at_x.lo);
    range.hi = std::max(range.hi, at_x.hi);
    if (range.lo < 0 && range.hi > 0) break; // neither sign
  }
  return range;
}

double edge_margin(const RayEnds& ends, double v) { return 64 * u * v * v * ends.longest; }

/// Whether all rays pass outside one edge, going through the plane one way. The edge functions'
/// sum has the sign of that way, so that where one is of the other sign by four margins, another
/// is of this by two.
bool pass_an_edge(const FlatTriangle& t, const RayEnds& ends, const Range& x, const Range& y,
                  double v) {
  const bool up = y.lo > x.hi;
  if (!up && !(y.hi < x.lo)) return false;
  const double margin = 4 * edge_margin(ends, v);
  for (std::size_t k = 0; k < 3; ++k) {
    const Range edge = edge_range(t.corners[k], t.corners[(k + 1) % 3], ends);
    if (up ? edge.hi < -margin : edge.lo > margin) return true;
  }
  return false;
}

} // namespace

void RayEnds::start_at(std::span<const glm::vec3> points) {
  origins.clear();
  from = Box::empty();
  for (const glm::vec3& p : points) {
    origins.emplace_back(p);
    from.extend(p);
  }
  const std::array<glm::dvec3, 3> axes = axes_of(origins);
  const glm::dvec3 base = origins.front();
  glm::dvec3 lo(0), hi(0);
  for (const glm::dvec3& p : origins)
    for (int k = 0; k < 3; ++k) {
      const double along = glm::dot(axes[std::size_t(k)], p - base);
      lo[k] = std::min(lo[k], along);
      hi[k] = std::max(hi[k], along);
    }
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = base + axes[0] * ((i & 1) != 0 ? hi.x : lo.x) +
                 axes[1] * ((i & 2) != 0 ? hi.y : lo.y) + axes[2] * ((i & 4) != 0 ? hi.z : lo.z);
}

void RayEnds::end_in(const Box& lights) {
  to = lights;
  longest = 0;
  longest = reach(*this, lights);
}

double reach(const RayEnds& ends, const Box& box) {
  const glm::dvec3 up = glm::dvec3(box.hi) - glm::dvec3(ends.from.lo);
  const glm::dvec3 down = glm::dvec3(ends.from.hi) - glm::dvec3(box.lo);
  return std::max(ends.longest, glm::length(glm::max(glm::abs(up), glm::abs(down))));
}

bool may_be_met_edge_on(const FlatTriangle& triangle, const Box& from, double longest) {
  const double margin = edge_on_margin(triangle, longest, shaft_margin * longest);
  return !(heights(triangle, from).least() > margin);
}

bool certainly_missed(const FlatTriangle& triangle, const RayEnds& ends, double separation) {
  Box own = Box::empty();
  for (const glm::dvec3& corner : triangle.corners) own.extend(glm::vec3(corner));
  const double v = reach(ends, own);
  Range x = heights(triangle, ends.from);
  const Range y = heights(triangle, ends.to);
  if (separation > 4 * u * v) {
    const double close = edge_on_margin(triangle, v, separation);
    if (x.least() > close || y.least() > 2 * close) return true;
    const auto is_apart = [&](const glm::dvec3& p) { return std::abs(triangle.height(p)) > close; };
    if (std::all_of(ends.origins.begin(), ends.origins.end(), is_apart)) return true;
    const double apart = std::max(x.lo - y.hi, y.lo - x.hi);
    if (apart >= safe_sine(triangle, v, separation) * ends.longest) return true;
  }
  // By the points, not their box, which a surface that they are on may run through.
  if (y.lo > 0 || y.hi < 0 || x.least() > 0) x = heights(triangle, ends.origins);
  return is_missed_above(triangle, x, y, v, ends.longest) ||
         is_missed_above(triangle, x.negated(), y.negated(), v, ends.longest) ||
         pass_an_edge(triangle, ends, x, y, v);
}

namespace {

/// Whether the plane is between all starts and all ends, so that each ray meets it for certain:
/// 0 < t < far.
bool divides(const FlatTriangle& t, const RayEnds& ends, double v) {
  const Range x = heights(t, ends.origins), y = heights(t, ends.to);
  if ((x.lo > 0) == (y.lo > 0) || (x.hi < 0) == (y.hi < 0)) return false;
  const double m = 4 * plane_margin(t, v);
  const double farthest = std::max(x.hi, -x.lo) + std::max(y.hi, -y.lo);
  return x.least() > m && y.least() > m + 0x1p-12 * farthest;
}

} // namespace

/// Partners' edge functions of the edge that they share are opposite, to the last bit: one of them
/// has it inside.
bool certainly_covers(const FlatTriangle& triangle, const FlatTriangle& partner,
                      const RayEnds& ends) {
  Box own = Box::empty();
  for (const glm::dvec3& corner : triangle.corners) own.extend(glm::vec3(corner));
  for (const glm::dvec3& corner : partner.corners) own.extend(glm::vec3(corner));
  const double v = reach(ends, own);
  if (!divides(triangle, ends, v)) return false;
  const bool is_alone = &partner == &triangle;
  if (!is_alone && !divides(partner, ends, v)) return false;
  const auto& [a, b, c] = triangle.corners;
  const std::array<glm::dvec3, 4> round = {b, c, a, partner.corners[2]};
  const std::size_t sides = is_alone ? 3 : 4;
  const double margin = edge_margin(ends, v);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t side = 0; side < sides; ++side) {
    const Range edge = edge_range(round[side], round[(side + 1) % sides], ends);
    least = std::min(least, edge.lo);
    most = std::max(most, edge.hi);
    if (!(least > margin) && !(most < -margin)) return false;
  }
  return true;
}

} // namespace lightcuts
