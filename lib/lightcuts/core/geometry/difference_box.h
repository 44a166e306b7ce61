// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/numerics/exact_dot.h>

namespace lightcuts {

/// The box that q = y - x ranges over, metres: all that a bound knows of the two ends, x a point or
/// in a box, y in a box.
struct DifferenceBox {
  glm::dvec3 lo, hi;

  /// y in the box, seen from x: rounded to nearest. Both have to outlive this, for where rounding
  /// would show the differences are taken without any.
  DifferenceBox(const glm::vec3& x, const Box& y)
      : lo(glm::dvec3(y.lo) - glm::dvec3(x)), hi(glm::dvec3(y.hi) - glm::dvec3(x)), x_(&x), y_(&y) {
  }
  /// Both ends in boxes: rounded outwards, so that every difference lies in it.
  [[nodiscard]] static DifferenceBox between(const Box& x, const Box& y);

  /// q of the corner whose bits say hi.
  [[nodiscard]] glm::dvec3 corner(int bits) const {
    return {(bits & 1) != 0 ? hi.x : lo.x, (bits & 2) != 0 ? hi.y : lo.y,
            (bits & 4) != 0 ? hi.z : lo.z};
  }
  /// n.q there, relative error dot_error, zero and sign exact; n of any length.
  [[nodiscard]] double dot_at(int bits, const glm::vec3& n) const {
    const glm::dvec3 q = corner(bits);
    const double a = n.x * q.x, b = n.y * q.y, c = n.z * q.z;
    const double sum = a + b + c;
    if (std::abs(sum) >= 0x1p-16 * (std::abs(a) + std::abs(b) + std::abs(c))) [[likely]]
      return sum;
    return exact_dot_at(bits, n);
  }
  /// dot_at() by exact arithmetic. Slow.
  [[nodiscard]] double exact_dot_at(int bits, const glm::vec3& n) const;

  /// The corner where n.q is largest.
  [[nodiscard]] static int farthest_along(const glm::vec3& n) {
    return (n.x > 0 ? 1 : 0) | (n.y > 0 ? 2 : 0) | (n.z > 0 ? 4 : 0);
  }
  /// A single q.
  [[nodiscard]] bool is_point() const { return lo == hi; }

private:
  DifferenceBox(const glm::dvec3& least, const glm::dvec3& most) : lo(least), hi(most) {}

  const glm::vec3* x_ = nullptr; ///< none: lo and hi are as they are
  const Box* y_ = nullptr;
};

/// min |q|^2 over the box, 0 if and only if it contains 0; relative error 2^-50.
[[nodiscard]] inline double min_length2(const DifferenceBox& q) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double nearest = std::max({q.lo[i], -q.hi[i], 0.0});
    sum += nearest * nearest;
  }
  return sum;
}

/// max |q|^2 over the box; relative error 2^-50.
[[nodiscard]] inline double max_length2(const DifferenceBox& q) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double farthest = std::max(q.hi[i], -q.lo[i]);
    sum += farthest * farthest;
  }
  return sum;
}

} // namespace lightcuts
