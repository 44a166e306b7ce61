// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lightcuts/core/kernels/contribution.h>

namespace lightcuts::oracle {

/// f n.l n.v with light from l seen from v, and with light from v seen from l.
struct BothWays {
  glm::dvec3 there{0}, back{0};
  glm::dvec3 allowed{0}; ///< what rounding may make of the difference; see both_ways()
};

namespace detail {

/// How far two of the lobe's values may differ that are equal by definition, apart from the error
/// of evaluating them.
template <class OneLobe>
glm::dvec3 input_rounding(const OneLobe& /*lobe*/, const ShadingFrame& /*frame*/,
                          const glm::vec3& /*l*/) {
  return glm::dvec3(0);
}
/// cos(r,l) = cos(r',v) for the mirror directions r of v and r' of l, but ShadingFrame rounds both
/// to floats: each angle is off by up to mirror_error, so they differ by twice that at most.
inline glm::dvec3 input_rounding(const Phong& phong, const ShadingFrame& frame,
                                 const glm::vec3& l) {
  const glm::dvec3 r(frame.mirror()), d(l);
  const double angle = std::atan2(glm::length(glm::cross(r, d)), glm::dot(r, d));
  const auto lobe_at = [&](double a) {
    return phong.normalisation() * std::pow(std::max(0.0, std::cos(a)), double(phong.exponent));
  };
  constexpr double off = 2 * ShadingFrame::mirror_error;
  const double most = lobe_at(std::max(0.0, angle - off));
  const double least = angle + off < 0.5 * std::numbers::pi ? lobe_at(angle + off) : 0;
  return glm::dvec3(phong.reflectance) * (most - least);
}

} // namespace detail

/// Evaluates the material both ways; n, l and v are unit vectors, l and v above the surface.
/// allowed: transfer_error of each, what is below its domain, 10^-150, and the rounding of Phong's
/// mirror directions.
[[nodiscard]] inline BothWays both_ways(const Material& material, const glm::vec3& n,
                                        const glm::vec3& l, const glm::vec3& v) {
  const ShadingPoint from_v(glm::vec3(0), n, v, material), from_l(glm::vec3(0), n, l, material);
  const auto sun = [](const glm::vec3& direction) {
    return Light{.kind = LightKind::directional, .position = direction};
  };
  BothWays ways;
  const double light_cosine = from_l.viewer_cosine(), viewer_cosine = from_v.viewer_cosine();
  ways.there = transfer(from_v, sun(l)) * viewer_cosine;
  ways.back = transfer(from_l, sun(v)) * light_cosine;
  ways.allowed = std::visit(
      [&](const auto& lobe) {
        return detail::input_rounding(lobe, from_v, l) * (light_cosine * viewer_cosine);
      },
      material.lobe);
  // The cosine that is multiplied here has an error of dot_error and a few roundings.
  ways.allowed += (ways.there + ways.back) * (transfer_error + 2 * dot_error) + 1e-150;
  return ways;
}

} // namespace lightcuts::oracle
