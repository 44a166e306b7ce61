// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/vec3.hpp>
#include <lightcuts/box.h>
#include <lightcuts/exact_dot.h>

namespace lightcuts {

/// Relative error, either way, of the suprema below.
inline constexpr double box_bound_error = 0x1p-32;

namespace detail {

/// One coordinate of the path q(s) = clamp(s n, lo, hi), mirrored so that n >= 0: it rests at `low`
/// until s = enter, equals s n until s = leave, and rests at `high` from there on.
struct PathCoordinate {
  double n, low, high, enter, leave;

  static PathCoordinate make(float normal, double lo, double hi) {
    constexpr double never = std::numeric_limits<double>::infinity();
    if (normal == 0) {
      const double rest = std::clamp(0.0, lo, hi);
      return {0, rest, rest, never, never};
    }
    const double n = std::abs(double(normal));
    if (normal < 0) {
      std::swap(lo, hi);
      lo = -lo;
      hi = -hi;
    }
    // s starts at 0: a coordinate that could only move at s < 0 rests at its high end throughout.
    return {n, lo, hi, lo > 0 ? lo / n : 0.0, hi > 0 ? hi / n : 0.0};
  }
};

/// Along one segment of the path: n.q = a + s b, |q|^2 = c + s^2 b.
struct PathSegment {
  double a = 0, b = 0, c = 0;
};

inline PathSegment segment_at(const std::array<PathCoordinate, 3>& path, double s,
                              const glm::vec3& n, const glm::vec3& x, const Box& box) {
  PathSegment segment;
  double scale = 0;
  glm::vec3 resting_n(0), corner(x);
  for (int i = 0; i < 3; ++i) {
    const auto& p = path[i];
    if (p.enter <= s && s < p.leave) {
      segment.b += p.n * p.n;
      continue;
    }
    const bool at_low = s < p.enter;
    const double q = at_low ? p.low : p.high;
    segment.a += p.n * q;
    segment.c += q * q;
    scale += p.n * std::abs(q);
    resting_n[i] = n[i];
    corner[i] = at_low == (n[i] > 0) ? box.lo[i] : box.hi[i];
  }
  if (std::abs(segment.a) < 0x1p-16 * scale) [[unlikely]]
    segment.a = exact_dot(resting_n, x, corner);
  return segment;
}

/// sup over the box of max(0, n.q) / |q|^K, K = 1 or 3, q = y - x, y in the box; n needs no length.
///
/// {q : n.q >= g |q|^K} is convex for g > 0, so the objective is quasi-concave where it is
/// positive, and its stationarity conditions over a box are q = clamp(s n, lo, hi) with
///   K s n.q = |q|^2 .
/// K n.q(s) - |q(s)|^2 / s increases with s, so there is one root; it is found segment by segment
/// of the piecewise linear path. n.q at the root is taken as |q|^2 / (K s), which cannot cancel.
/// 0 if and only if n.q <= 0 all over the box; +inf if and only if the supremum is (K = 3, x in the
/// box, and some q with n.q > 0).
template <int K>
[[nodiscard]] double sup_dot_over_power(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  static_assert(K == 1 || K == 3);
  glm::vec3 top;
  for (int i = 0; i < 3; ++i) top[i] = n[i] > 0 ? box.hi[i] : box.lo[i];
  if (dot_between(n, x, top) <= 0) return 0;

  std::array<PathCoordinate, 3> path{};
  for (int i = 0; i < 3; ++i)
    path[i] = PathCoordinate::make(n[i], double(box.lo[i]) - x[i], double(box.hi[i]) - x[i]);

  double s = 0;
  for (;;) {
    const PathSegment g = segment_at(path, s, n, x, box);
    if (g.c == 0) {
      if constexpr (K == 1) return std::sqrt(g.b);
      return std::numeric_limits<double>::infinity();
    }
    double end = std::numeric_limits<double>::infinity();
    for (const auto& p : path) {
      if (p.enter > s) end = std::min(end, p.enter);
      if (p.leave > s) end = std::min(end, p.leave);
    }
    const bool last = end == std::numeric_limits<double>::infinity();
    if (last || (K - 1) * g.b * end * end + K * g.a * end >= g.c) {
      if constexpr (K == 1) {
        // Rounding may have missed the root at the end of the segment before; the one of this
        // segment's line may then lie far ahead of it.
        const double root = std::max(g.c / g.a, s);
        return (g.a + root * g.b) / std::sqrt(g.c + root * g.b * root);
      }
      const double d = std::sqrt(9 * g.a * g.a + 8 * g.b * g.c);
      const double root = g.a > 0 ? 2 * g.c / (3 * g.a + d) : (d - 3 * g.a) / (4 * g.b);
      // In this order: root alone may exceed 10^160, where b is 0.
      return 1 / (3 * root * std::sqrt(g.c + root * g.b * root));
    }
    s = end;
  }
}

} // namespace detail

/// sup of max(0, n.q)/|q| over the box: |n| times the largest cosine. If x lies in the box, over
/// q != 0.
[[nodiscard]] inline double max_cosine(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  return detail::sup_dot_over_power<1>(n, x, box);
}

/// sup of max(0, n.q)/|q|^3 over the box: |n| times Lambert's cosine and the geometric term 1/|q|^2
/// in one, tighter than the product of their suprema.
[[nodiscard]] inline double max_cosine_over_distance2(const glm::vec3& n, const glm::vec3& x,
                                                      const Box& box) {
  return detail::sup_dot_over_power<3>(n, x, box);
}

/// min of max(0, n.q)/|q|^3 over the box, relative error box_bound_error: at a corner, because the
/// objective is quasi-concave where it is positive. 0 if some q has n.q <= 0, or is 0.
[[nodiscard]] inline double min_cosine_over_distance2(const glm::vec3& n, const glm::vec3& x,
                                                      const Box& box) {
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 y((corner & 1) != 0 ? box.hi.x : box.lo.x,
                      (corner & 2) != 0 ? box.hi.y : box.lo.y,
                      (corner & 4) != 0 ? box.hi.z : box.lo.z);
    const double n_dot_q = dot_between(n, x, y);
    if (n_dot_q <= 0) return 0;
    double length2 = 0;
    for (int i = 0; i < 3; ++i) length2 += (double(y[i]) - x[i]) * (double(y[i]) - x[i]);
    least = std::min(least, n_dot_q / (length2 * std::sqrt(length2)));
  }
  return least;
}

/// min |q|^2 over the box, 0 if and only if x lies in it; relative error 2^-50.
[[nodiscard]] inline double min_distance2(const glm::vec3& x, const Box& box) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double q = std::max({double(box.lo[i]) - x[i], x[i] - double(box.hi[i]), 0.0});
    sum += q * q;
  }
  return sum;
}

} // namespace lightcuts
