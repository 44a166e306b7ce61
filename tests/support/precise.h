// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <lightcuts/light_set.h>
#include <lightcuts/light_tree.h>
#include <lightcuts/shading_point.h>

/// Real numbers, or so nearly that no float and no double can tell the difference.
namespace lightcuts::precise {

namespace mp = boost::multiprecision;

/// Dot products of floats need bits 2^-298 .. 2^259 and are exact in these 720; any exponent.
using Exact = mp::number<mp::cpp_bin_float<720, mp::digit_base_2>, mp::et_off>;
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

/// material(l) in the direction of a given cosine with the mirror direction; a cosine <= 0: no
/// lobe.
inline Colour brdf(const Material& m, const Quad& mirror_cosine) {
  const Quad lobe = mirror_cosine > 0
                        ? (Quad(m.exponent) + 2) / (2 * pi()) * power(mirror_cosine, m.exponent)
                        : Quad(0);
  Colour f;
  for (int c = 0; c < 3; ++c) f[c] = Quad(m.diffuse[c]) / pi() + Quad(m.specular[c]) * lobe;
  return f;
}

/// transfer() in real numbers.
inline Colour transfer(const ShadingPoint& point, const glm::vec3& y) {
  const Quad n_dot_q(dot(point.normal(), point.position(), y));
  if (n_dot_q <= 0) return {};
  const Quad d2(distance2(point.position(), y));
  const Quad d = sqrt(d2);
  Quad cosine = 0;
  if (point.material().has_specular())
    cosine = Quad(dot(point.mirror(), point.position(), y)) / (length(point.mirror()) * d);
  Colour f = brdf(point.material(), cosine);
  for (Quad& v : f) v *= n_dot_q / (length(point.normal()) * d2 * d);
  return f;
}

inline Colour contribution(const ShadingPoint& point, const OmniLight& light) {
  Colour f = precise::transfer(point, light.position);
  for (int c = 0; c < 3; ++c) f[c] *= Quad(light.intensity[c]);
  return f;
}

/// The sum over all lights that `visible` says are seen.
template <class Visible>
Colour sum(const LightSet& lights, const ShadingPoint& point, Visible&& visible) {
  Colour total{};
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (!visible(i)) continue;
    const Colour one = contribution(point, lights[i]);
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
      result[i] = contribution(point, tree.lights()[node.representative]);
      continue;
    }
    for (int c = 0; c < 3; ++c)
      result[i][c] = result[node.first_child][c] + result[node.first_child + 1][c];
  }
  return result;
}

} // namespace lightcuts::precise
