// SPDX-License-Identifier: MIT
#include <lightcuts/core/geometry/difference_box.h>

#include <limits>

#include <lightcuts/core/numerics/expansion.h>

namespace lightcuts {
namespace {

/// a - b, rounded towards `to` where it is not exact (Dekker 1971, "two-sum").
double difference_towards(double to, double a, double b) {
  const double d = a - b;
  const double b_seen = a - d;
  const double lost = (a - (d + b_seen)) + (b_seen - b);
  const bool beyond = to > 0 ? lost > 0 : lost < 0;
  return beyond ? std::nextafter(d, to) : d;
}

} // namespace

DifferenceBox DifferenceBox::between(const Box& x, const Box& y) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  glm::dvec3 lo, hi;
  for (int i = 0; i < 3; ++i) {
    lo[i] = difference_towards(-inf, y.lo[i], x.hi[i]);
    hi[i] = difference_towards(inf, y.hi[i], x.lo[i]);
  }
  return {lo, hi};
}

double DifferenceBox::exact_dot_at(int bits, const glm::vec3& n) const {
  if (x_ != nullptr)
    return exact_dot(n, *x_,
                     {(bits & 1) != 0 ? y_->hi.x : y_->lo.x, (bits & 2) != 0 ? y_->hi.y : y_->lo.y,
                      (bits & 4) != 0 ? y_->hi.z : y_->lo.z});
  const glm::dvec3 q = corner(bits);
  Expansion<6> sum;
  for (int i = 0; i < 3; ++i) sum.add_product(n[i], q[i]);
  return sum.rounded();
}

} // namespace lightcuts
