// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// Closed axis-aligned box. Empty while lo > hi in any axis.
struct Box {
  glm::vec3 lo, hi;

  [[nodiscard]] static Box empty() {
    const glm::vec3 infinity(std::numeric_limits<float>::infinity());
    return {infinity, -infinity};
  }
  void extend(const glm::vec3& p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  void extend(const Box& other) {
    lo = glm::min(lo, other.lo);
    hi = glm::max(hi, other.hi);
  }
  [[nodiscard]] bool contains(const glm::vec3& p) const {
    return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
  }
  [[nodiscard]] bool contains(const Box& other) const {
    return contains(other.lo) && contains(other.hi);
  }
  bool operator==(const Box&) const = default;
};

/// Squared diagonal of the smallest box around both. Each step rounds monotonically, so a larger
/// box never gets a smaller value.
[[nodiscard]] inline double squared_diagonal_of_union(const Box& a, const Box& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double extent = double(glm::max(a.hi[i], b.hi[i])) - double(glm::min(a.lo[i], b.lo[i]));
    sum += extent * extent;
  }
  return sum;
}

} // namespace lightcuts
