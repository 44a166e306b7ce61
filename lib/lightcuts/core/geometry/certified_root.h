// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/difference_box.h>

namespace lightcuts::detail {

/// The value of certified_sup() and certified_value() where they cannot tell, which is rare.
inline constexpr double undecided = -1;

/// The path q(s) = clamp(s n, lo, hi) in the unknowns c_i = q_i / n_i = clamp(s, enter_i, leave_i),
/// so that n.q = sum w_i c_i and |q|^2 = rest2 + sum w_i c_i^2, w_i = n_i^2. rest2 is of the axes
/// with n_i = 0, whose w_i and c_i are 0.
///
/// n.q/|q|^3 is largest at the root of h(s) = 3 s n.q - |q|^2, if some n.q > 0; see
/// stationary_point(). Here it is guessed, nearly always rightly at once, and the guess certified.
/// With n and both ends of q in floats nothing over- or underflows.
struct ScaledPath {
  using Vector = std::array<double, 3>;
  Vector w, enter, leave;
  double rest2 = 0;

  [[gnu::always_inline]] ScaledPath(const glm::vec3& n, const DifferenceBox& q) {
    for (int i = 0; i < 3; ++i) {
      const double lo = q.lo[i], hi = q.hi[i];
      w[i] = double(n[i]) * n[i];
      if (n[i] != 0) {
        const double inverse = 1 / double(n[i]);
        enter[i] = smaller(lo * inverse, hi * inverse);
        leave[i] = larger(lo * inverse, hi * inverse);
      } else {
        enter[i] = leave[i] = 0;
        const double rest = smaller(larger(0, lo), hi);
        rest2 += rest * rest;
      }
    }
  }

  // By value: minsd and maxsd, where std::min and std::max make branches.
  [[gnu::always_inline]] static double smaller(double a, double b) { return a < b ? a : b; }
  [[gnu::always_inline]] static double larger(double a, double b) { return a > b ? a : b; }
  [[gnu::always_inline]] [[nodiscard]] double at(int i, double s) const {
    return smaller(larger(s, enter[i]), leave[i]);
  }

  /// The root of the quadratic that h is around s = over / under, where c_i that rest at s are
  /// taken to rest; under > 0. +inf where it has none.
  [[gnu::always_inline]] [[nodiscard]] double root_near(double over, double under) const {
    double a = 0, b = 0, c = rest2; // n.q = a + s b, |q|^2 = c + s^2 b
    for (int i = 0; i < 3; ++i) {
      const bool before = over < enter[i] * under;
      const double left = over >= leave[i] * under ? w[i] : 0;
      const double resting = before ? w[i] : left;
      const double at = before ? enter[i] : leave[i];
      a += resting * at;
      b += w[i] - resting;
      c += resting * at * at;
    }
    if (b == 0) return a > 0 ? c / (3 * a) : std::numeric_limits<double>::infinity();
    const double d = std::sqrt(9 * a * a + 8 * b * c);
    return a > 0 ? 2 * c / (3 * a + d) : (d - 3 * a) / (4 * b);
  }
};

/// sup over the box of max(0, n.q)/|q|^3, relative error box_bound_error, 0 and +inf exact; or
/// `undecided`.
///
/// However s >= 0 was found, it is certified. d(h/s)/ds = |q|^2/s^2 + (sum of w_i over moving c_i),
/// and along the path |q| does not fall and |q|/s does not rise, so that from the root s* to s
///   |h(s)| >= |q(s)|^2 (1 - min(s/s*, s*/s)) .
/// So |h| <= 2^-34 |q|^2 puts s within 2^-34 of s*, and 1/(3 s |q|), which is n.q/|q|^3 at the root
/// and changes at most as s^2, within 2^-33 of it, and a few roundings. h itself: c_i errs by three
/// roundings of 2^-53, and a term of h by at most twice that and six more: together by less than
/// 2^-49 of the terms' magnitudes, which in turn are known that well. With x in the box s = 0.
[[gnu::always_inline]] [[nodiscard]] inline double certified_sup(const glm::vec3& n,
                                                                 const DifferenceBox& q) {
  const ScaledPath path(n, q);
  double front = 0, front_magnitude = 0, end2 = path.rest2;
  for (int i = 0; i < 3; ++i) {
    const double n_q = path.w[i] * path.leave[i];
    front += n_q;
    front_magnitude += std::abs(n_q);
    end2 += n_q * path.leave[i];
  }
  if (!(std::abs(front) >= 0x1p-48 * front_magnitude)) [[unlikely]]
    return undecided;
  if (front <= 0) return 0;

  // First near the root that all would have at their ends.
  double s = path.root_near(end2, 3 * front);
  for (int attempt = 0; attempt < 4; ++attempt) {
    double n_dot_q = 0, magnitude = 0, length2 = path.rest2;
    for (int i = 0; i < 3; ++i) {
      const double c = path.at(i, s);
      const double n_q = path.w[i] * c;
      n_dot_q += n_q;
      magnitude += std::abs(n_q);
      length2 += n_q * c;
    }
    const double h = std::abs(3 * s * n_dot_q - length2);
    if (h + 0x1p-48 * (3 * s * magnitude + length2) <= 0x1p-34 * length2)
      return 1 / (3 * s * std::sqrt(length2));
    s = path.root_near(s, 1);
  }
  return undecided;
}

/// sup of max(0, n.q)/|q|^3 over a box that is one point, or `undecided`. n.q errs by
/// four roundings of 2^-53, amplified at most 2^16 times, and the rest by less than 2^-49.
[[gnu::always_inline]] [[nodiscard]] inline double certified_value(const glm::vec3& n,
                                                                   const DifferenceBox& box) {
  double n_dot_q = 0, magnitude = 0, length2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double q = box.lo[i];
    n_dot_q += n[i] * q;
    magnitude += std::abs(n[i] * q);
    length2 += q * q;
  }
  if (!(std::abs(n_dot_q) >= 0x1p-16 * magnitude)) [[unlikely]]
    return undecided;
  return n_dot_q <= 0 ? 0 : n_dot_q / (length2 * std::sqrt(length2));
}

} // namespace lightcuts::detail
