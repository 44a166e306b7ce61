// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <oracle/truth/lobes/lobe_truth.h>

/// What lobes about the half vector share, that of light and viewer.
namespace lightcuts::oracle::radiometry {

/// half_tangent2(), each time anew.
template <class Real>
Real half_tangent2_of(const Way<Real>& way) {
  const Real v_length = length<Real>(way.point.to_viewer());
  const Real n_length = length<Real>(way.point.normal());
  Vector<Real> sum, n;
  for (int i = 0; i < 3; ++i) {
    const auto k = std::size_t(i);
    sum[k] = way.q[k] / way.distance + Real(way.point.to_viewer()[i]) / v_length;
    n[k] = Real(way.point.normal()[i]) / n_length;
  }
  if constexpr (!std::is_same_v<Real, Exact>)
    if (dot(sum, sum) < Real(0x1p-4)) return Real(half_tangent2_of(way.exact()));
  const Real up = way.n_dot_l + viewer_cosine<Real>(way.point);
  // |n x (l + v)| is the part along the surface.
  const Vector<Real> along = cross(n, sum);
  return dot(along, along) / (up * up);
}

/// tan^2 of the angle between the normal and l + v: what is left of l + v without its part along
/// the normal, over that part. In 700 bits where l and v cancel, as they do near the horizon with h
/// near the normal: both parts are above 2^-300 or 0.
template <class Real>
Real half_tangent2(const Way<Real>& way) {
  if (!way.known_half_tangent2) way.known_half_tangent2 = half_tangent2_of(way);
  return *way.known_half_tangent2;
}

/// Width of a distribution of facets: the ends of its domain, and all scales between.
inline float random_alpha(gen::Dice& dice) {
  return dice.one_in(2) ? dice.pick({0x1p-14F, 1.0F, 0.1F, 0.5F, 1e-3F})
                        : std::clamp(std::abs(dice.log_uniform(-4.2, 0)), 0x1p-14F, 1.0F);
}

} // namespace lightcuts::oracle::radiometry
