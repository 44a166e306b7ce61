// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <lightcuts/core/tree/light_tree.h>
#include <oracle/truth/radiometry.h>

/// Real numbers, or so nearly that no float and no double can tell the difference.
namespace lightcuts::precise {

namespace mp = boost::multiprecision;

/// Dot products of floats need bits 2^-298 .. 2^259 and are exact in these 700; any exponent.
using Exact = oracle::Exact;
/// 128 bits, any exponent: relative error 2^-127 per operation.
using Quad = mp::number<mp::cpp_bin_float<128, mp::digit_base_2>, mp::et_off>;
/// One number per colour channel.
using Colour = std::array<Quad, 3>;

inline Exact square(const Exact& v) { return v * v; }

/// n.(y - x), exactly.
inline Exact dot(const glm::vec3& n, const glm::vec3& x, const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += Exact(n[i]) * (Exact(y[i]) - Exact(x[i]));
  return sum;
}

/// |y - x|^2, exactly.
inline Exact distance2(const glm::vec3& x, const glm::vec3& y) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) sum += square(Exact(y[i]) - Exact(x[i]));
  return sum;
}

inline Quad length(const glm::vec3& v) { return sqrt(Quad(distance2(glm::vec3(0), v))); }

/// base^exponent; 2^20 multiplications lose less than 20 of the 128 bits.
inline Quad power(Quad base, float exponent) {
  auto whole = static_cast<std::uint32_t>(exponent);
  const float fraction = exponent - static_cast<float>(whole);
  Quad result = fraction == 0 ? Quad(1) : base == 0 ? Quad(0) : Quad(pow(base, Quad(fraction)));
  for (; whole != 0; whole >>= 1, base *= base)
    if ((whole & 1U) != 0) result *= base;
  return result;
}

inline Quad pi() { return boost::math::constants::pi<Quad>(); }

/// Radiance that the light sends to the viewer, in real numbers.
inline Colour contribution(const ShadingPoint& point, const Light& light, float min_distance = 0) {
  return oracle::radiometry::contribution<Quad>(light, point, min_distance);
}

/// That of an omni light of intensity 1.
inline Colour transfer(const ShadingPoint& point, const glm::vec3& y) {
  return contribution(point, {.position = y, .intensity = glm::vec3(1)});
}

/// The sum over all lights that `visible` says are seen.
template <class Visible>
Colour sum(const LightSet& lights, const ShadingPoint& point, Visible&& visible) {
  Colour total{};
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (!visible(i)) continue;
    const Colour one = contribution(point, lights[i], lights.min_distance());
    for (int c = 0; c < 3; ++c) total[c] += one[c];
  }
  return total;
}

/// What every node of the tree contributes with all its lights visible.
inline std::vector<Colour> contributions(const LightTree& tree, const ShadingPoint& point) {
  std::vector<Colour> result(tree.nodes().size());
  for (std::size_t i = result.size(); i-- > 0;) {
    const TreeNode& node = tree.nodes()[i];
    if (node.is_leaf()) {
      result[i] =
          contribution(point, tree.lights()[node.representative], tree.lights().min_distance());
      continue;
    }
    for (int c = 0; c < 3; ++c)
      result[i][c] = result[node.first_child][c] + result[node.first_child + 1][c];
  }
  return result;
}

} // namespace lightcuts::precise
