// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/certified_root.h>
#include <lightcuts/core/geometry/difference_box.h>
#include <lightcuts/core/numerics/angle.h>

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
                              const glm::vec3& n, const DifferenceBox& box) {
  PathSegment segment;
  double scale = 0;
  glm::vec3 resting_n(0);
  int corner = 0;
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
    if (at_low != (n[i] > 0)) corner |= 1 << i;
  }
  if (std::abs(segment.a) < 0x1p-16 * scale) [[unlikely]]
    segment.a = box.exact_dot_at(corner, resting_n);
  return segment;
}

/// Where the path has its root: see stationary_point().
struct PathRoot {
  std::array<PathCoordinate, 3> path;
  PathSegment segment; ///< the one with the root
  double s = 0;
};

/// Whether n.q > 0 for some q of the box.
[[nodiscard]] inline bool reaches_front(const glm::vec3& n, const DifferenceBox& q) {
  return q.dot_at(DifferenceBox::farthest_along(n), n) > 0;
}

/// Where n.q / |q|^K, K = 1 or 3, is largest over a box with some n.q > 0; n needs no
/// length.
///
/// {q : n.q >= g |q|^K} is convex for g > 0, so the objective is quasi-concave where it is
/// positive, and its stationarity conditions over a box are q = clamp(s n, lo, hi) with
///   K s n.q = |q|^2 .
/// K n.q(s) - |q(s)|^2 / s increases with s, so there is one root; it is found segment by segment
/// of the piecewise linear path. A segment with c = 0 means that the path starts at 0, in the box:
/// its root is s = 0.
template <int K>
[[nodiscard]] PathRoot stationary_point(const glm::vec3& n, const DifferenceBox& box) {
  static_assert(K == 1 || K == 3);
  PathRoot root;
  for (int i = 0; i < 3; ++i) root.path[i] = PathCoordinate::make(n[i], box.lo[i], box.hi[i]);
  for (;;) {
    const PathSegment& g = root.segment = segment_at(root.path, root.s, n, box);
    if (g.c == 0) return root;
    double end = std::numeric_limits<double>::infinity();
    for (const auto& p : root.path) {
      if (p.enter > root.s) end = std::min(end, p.enter);
      if (p.leave > root.s) end = std::min(end, p.leave);
    }
    const bool last = end == std::numeric_limits<double>::infinity();
    if (last || (K - 1) * g.b * end * end + K * g.a * end >= g.c) {
      if constexpr (K == 1) {
        // Rounding may have missed the root at the end of the segment before; the one of this
        // segment's line may then lie far ahead of it.
        root.s = std::max(g.c / g.a, root.s);
      } else {
        const double d = std::sqrt(9 * g.a * g.a + 8 * g.b * g.c);
        root.s = g.a > 0 ? 2 * g.c / (3 * g.a + d) : (d - 3 * g.a) / (4 * g.b);
      }
      return root;
    }
    root.s = end;
  }
}

/// sup over the box of max(0, n.q) / |q|^K. n.q at the root is taken as |q|^2 / (K s), which cannot
/// cancel. 0 if and only if n.q <= 0 all over the box; +inf if and only if the supremum is (K = 3,
/// 0 in the box, and some q with n.q > 0).
template <int K>
[[nodiscard]] double sup_dot_over_power(const glm::vec3& n, const DifferenceBox& box) {
  if (!reaches_front(n, box)) return 0;
  const PathRoot root = stationary_point<K>(n, box);
  const PathSegment& g = root.segment;
  if (g.c == 0) {
    if constexpr (K == 1) return std::sqrt(g.b);
    return std::numeric_limits<double>::infinity();
  }
  if constexpr (K == 1)
    return (g.a + root.s * g.b) / std::sqrt(g.c + root.s * g.b * root.s);
  else // in this order: s alone may exceed 10^160, where b is 0
    return 1 / (3 * root.s * std::sqrt(g.c + root.s * g.b * root.s));
}

/// sup_dot_over_power<3>(), out of the way of what is quicker; n can stay in registers there.
[[gnu::noinline, gnu::cold]] inline double walked_sup(glm::vec3 n, const DifferenceBox& box) {
  return sup_dot_over_power<3>(n, box);
}

/// The q with the largest n.q/|q| over a box with some n.q > 0; where that is approached at q = 0
/// only, a direction.
inline glm::dvec3 nearest_in_front(const glm::vec3& n, const DifferenceBox& box) {
  const PathRoot root = stationary_point<1>(n, box);
  glm::dvec3 q;
  for (int i = 0; i < 3; ++i) {
    const PathCoordinate& p = root.path[i];
    const bool moves = p.enter <= root.s && root.s < p.leave;
    if (root.segment.c == 0)
      q[i] = moves ? p.n : 0;
    else
      q[i] = moves ? std::clamp(root.s * p.n, p.low, p.high) : root.s < p.enter ? p.low : p.high;
    if (n[i] < 0) q[i] = -q[i];
  }
  return q;
}

} // namespace detail

/// sup of max(0, n.q)/|q| over the box: |n| times the largest cosine. If 0 lies in the box, over
/// q != 0.
[[nodiscard]] inline double max_cosine(const glm::vec3& n, const DifferenceBox& q) {
  return detail::sup_dot_over_power<1>(n, q);
}

/// sup of max(0, n.q)/|q|^3 over the box: |n| times Lambert's cosine and the geometric term 1/|q|^2
/// in one, tighter than the product of their suprema.
[[nodiscard, gnu::always_inline]] inline double max_cosine_over_distance2(const glm::vec3& n,
                                                                          const DifferenceBox& q) {
  const double sup = q.is_point() ? detail::certified_value(n, q) : detail::certified_sup(n, q);
  return sup != detail::undecided ? sup : detail::walked_sup(n, q);
}

/// The smallest angle between n and q != 0; within angle_error. Where some n.q > 0 see
/// stationary_point(). Else -n.q/|q| is quasi-concave, and least at a corner.
[[nodiscard]] inline Angle min_angle(const glm::vec3& n, const DifferenceBox& box) {
  if (detail::reaches_front(n, box)) return angle_between(n, detail::nearest_in_front(n, box));
  Angle best{-2, 0};
  for (int bits = 0; bits < 8; ++bits) {
    const glm::dvec3 q = box.corner(bits);
    if (q == glm::dvec3(0)) continue;
    const Angle angle = angle_between(n, q);
    if (angle.cos > best.cos) best = angle;
  }
  return best.cos < -1 ? Angle{} : best; // the box is 0 alone
}

/// min of max(0, n.q)/|q| falloff(|q|^2) over the box, relative error box_bound_error: at a corner,
/// for a falloff that makes this quasi-concave where it is positive: 1, 1/|q|^2, and the smaller of
/// such. 0 if some q has n.q <= 0, or is 0.
template <class Falloff>
[[nodiscard]] double min_cosine_times(const glm::vec3& n, const DifferenceBox& box,
                                      Falloff&& falloff) {
  // n.q falloff lies between 2^-558 and 2^149, |q|^2 between 2^-298 and 2^262: squares are normal
  // so.
  constexpr double scaled_up = 0x1p180;
  double dots[3][2], squares[3][2];
  double scale = 0;
  for (int i = 0; i < 3; ++i)
    for (int high = 0; high < 2; ++high) {
      const double q = high ? box.hi[i] : box.lo[i];
      dots[i][high] = n[i] * q;
      squares[i][high] = q * q;
      scale = std::max(scale, std::abs(dots[i][high]));
    }
  double least_squared = std::numeric_limits<double>::infinity();
  for (int bits = 0; bits < 8; ++bits) {
    const int a = bits & 1, b = bits >> 1 & 1, c = bits >> 2;
    double n_dot_q = dots[0][a] + dots[1][b] + dots[2][c];
    if (std::abs(n_dot_q) < 0x1p-14 * scale) [[unlikely]] // a sum that may have lost its digits
      n_dot_q = box.dot_at(bits, n);
    if (n_dot_q <= 0) return 0;
    const double length2 = squares[0][a] + squares[1][b] + squares[2][c];
    const double unrooted = n_dot_q * falloff(length2) * scaled_up;
    least_squared = std::min(least_squared, unrooted * unrooted / length2); // one root will do
  }
  return std::sqrt(least_squared) / scaled_up;
}

// Bounds over the q = y - x of the points y of a box seen from a point x.

[[nodiscard]] inline double max_cosine(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  return max_cosine(n, DifferenceBox(x, box));
}
[[nodiscard, gnu::always_inline]] inline double
max_cosine_over_distance2(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  return max_cosine_over_distance2(n, DifferenceBox(x, box));
}
[[nodiscard]] inline Angle min_angle(const glm::vec3& n, const glm::vec3& x, const Box& box) {
  return min_angle(n, DifferenceBox(x, box));
}
template <class Falloff>
[[nodiscard]] double min_cosine_times(const glm::vec3& n, const glm::vec3& x, const Box& box,
                                      Falloff&& falloff) {
  return min_cosine_times(n, DifferenceBox(x, box), falloff);
}
[[nodiscard]] inline double min_distance2(const glm::vec3& x, const Box& box) {
  return min_length2(DifferenceBox(x, box));
}

} // namespace lightcuts
