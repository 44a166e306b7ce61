// SPDX-License-Identifier: MIT
#include <lightcuts/exact_dot.h>

#include <array>
#include <utility>

namespace lightcuts {
namespace {

/// Knuth's sum of two doubles: the rounded sum and, exactly, what rounding lost.
std::pair<double, double> two_sum(double a, double b) {
  const double sum = a + b;
  const double b_seen = sum - a;
  const double a_seen = sum - b_seen;
  return {sum, (a - a_seen) + (b - b_seen)};
}

} // namespace

double exact_dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  // Products of two floats have 48 bits and lie in [2^-298, 2^256]: exact in double.
  std::array<double, 6> term{double(n.x) * double(y.x), -double(n.x) * double(x.x),
                             double(n.y) * double(y.y), -double(n.y) * double(x.y),
                             double(n.z) * double(y.z), -double(n.z) * double(x.z)};
  // Shewchuk's grow-expansion: term[0..i] always holds a nonoverlapping expansion of their sum, in
  // ascending order; so the last sum below is within a few ulps of the whole and has its sign.
  for (std::size_t i = 1; i < term.size(); ++i) {
    double carry = term[i];
    for (std::size_t j = 0; j < i; ++j) {
      const auto [sum, lost] = two_sum(carry, term[j]);
      term[j] = lost;
      carry = sum;
    }
    term[i] = carry;
  }
  double sum = 0;
  for (const double t : term) sum += t;
  return sum;
}

} // namespace lightcuts
