// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <boost/math/constants/constants.hpp>
#include <glm/vec3.hpp>
#include <oracle/truth/square_root.h>
#include <oracle/truth/truth.h>

/// What lights and materials are by their definitions, for any type of number: long double, whose
/// errors are looked after, and one so wide that they do not matter. Nothing here is shared with
/// the library that is judged by it.
namespace lightcuts::oracle::radiometry {

template <class Real>
using Vector = std::array<Real, 3>;

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// n.(y - x) by six exact products.
[[nodiscard]] inline Exact dot_of_floats(const glm::vec3& n, const glm::vec3& x,
                                         const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += Exact(n[i]) * (Exact(y[i]) - Exact(x[i]));
  return sum;
}

/// n.(y - x) to a few ulps. In long double: six exact products summed twice as accurately (Ogita,
/// Rump & Oishi 2005, "Accurate sum and dot product"), or in 700 bits where even that cancels.
template <class Real>
Real dot_between(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  if constexpr (!std::is_same_v<Real, long double>) {
    return Real(dot_of_floats(n, x, y));
  } else {
    long double sum = 0, lost = 0, magnitude = 0;
    for (int i = 0; i < 3; ++i)
      for (const float v : {y[i], -x[i]}) {
        const long double term = static_cast<long double>(n[i]) * v; // 48 bits
        const long double next = sum + term;
        const long double seen = next - sum;
        lost += (sum - (next - seen)) + (term - seen);
        sum = next;
        magnitude += std::abs(term);
      }
    const long double result = sum + lost;
    // The second order error is below 36 eps^2 magnitude: relative eps needs 64 eps of it left.
    constexpr long double eps = std::numeric_limits<long double>::epsilon();
    if (magnitude == 0 || std::abs(result) >= 64 * eps * magnitude) return result;
    return static_cast<long double>(dot_of_floats(n, x, y));
  }
}

/// One colour scaled.
template <class Real>
Vector<Real> scaled(const glm::vec3& colour, const Real& by) {
  return {Real(colour.x) * by, Real(colour.y) * by, Real(colour.z) * by};
}

template <class Real>
Vector<Real> vector_of(const glm::vec3& v) {
  return {Real(v.x), Real(v.y), Real(v.z)};
}

template <class Real>
Real length(const glm::vec3& v) {
  return square_root<Real>(dot(vector_of<Real>(v), vector_of<Real>(v)));
}

template <class Real>
Real pi() {
  return boost::math::constants::pi<Real>();
}

} // namespace lightcuts::oracle::radiometry
