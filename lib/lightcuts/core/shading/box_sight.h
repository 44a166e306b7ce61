// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/geometry/box_bounds.h>
#include <lightcuts/core/numerics/angle.h>
#include <lightcuts/core/shading/shading_frame.h>

namespace lightcuts {

/// Upper bound of Schlick's (1 - v.h)^5, given a lower one of l.v.
[[nodiscard]] inline double max_schlick(double between_cosine) {
  const double w = 1 - std::sqrt(0.5 * (1 + between_cosine)) + 0x1p-44;
  const double kept = std::max(w, 0x1p-16); // so that rounding is small beside it
  return kept * kept * (kept * kept) * kept;
}

/// All lights of a box seen from a shading point: what lobes are bounded with. Notation as in
/// Sight; q ranges over the box.
struct BoxSight {
  const ShadingFrame& frame;
  glm::vec3 from;            ///< what q starts at; see viewed_from()
  const Box& box;            ///< of Light::position
  double max_cosine_falloff; ///< sup of n.l falloff; +inf allowed, > 0
  double max_falloff;        ///< sup of the falloff alone, 1/|q|^2 mostly; +inf allowed

  /// n.v.
  [[nodiscard]] double least_viewer_cosine() const { return frame.viewer_cosine(); }

  /// Largest cos(r,l), r the mirror direction as ShadingFrame has it; 0 if none is positive.
  [[nodiscard]] double max_mirror_cosine() const {
    return max_cosine(frame.mirror(), from, box) * frame.inverse_mirror_length();
  }

  /// Lower bound of tan^2(n,h). Mirroring v at h gives l, and at n gives r: one after the other
  /// they rotate by twice the angle between n and h, so that the angle between l and r is at most
  /// that. Hence (n,h) >= (r,l)/2, with equality in the plane of incidence; the least (r,l) is
  /// exact.
  [[nodiscard]] double min_half_tangent2() const {
    constexpr Angle uncertainty{1, ShadingFrame::mirror_error};
    const Angle least = difference(half(min_angle(frame.mirror(), from, box)), uncertainty);
    const double tangent =
        std::max(0.0, least.sin - 8 * angle_error) / (least.cos + 8 * angle_error);
    return tangent * tangent;
  }

  /// min_half_tangent2(), or a larger lower bound of tan^2(n,h) by cos^2(n,h) = (n.l + n.v)^2 / (2
  /// + 2 l.v), given an upper bound of n.l and a lower one of l.v: it helps aside of the plane of
  /// incidence. It is left out where rounding might show in a lobe.
  [[nodiscard]] double min_half_tangent2(double light_cosine, double between_cosine) const {
    const double up = light_cosine + frame.viewer_cosine(), sum2 = 2 + 2 * between_cosine;
    // What is subtracted makes up for the rounding of n.v and of this.
    const double tangent2 = (sum2 - 0x1p-44) * (1 - 0x1p-30) / (up * up) - 1;
    const bool counts = sum2 > 0x1p-12 && tangent2 > 0x1p-10;
    return std::max(min_half_tangent2(), counts ? tangent2 : 0);
  }

  /// Lower and upper bound of n.l, quickly: extremes of n.q and |q| apart. In [0, 1].
  [[nodiscard]] double min_cosine_quickly() const {
    return std::max(0.0, least_cosine(frame.normal(), frame.inverse_normal_length()));
  }
  [[nodiscard]] double max_cosine_quickly() const {
    double most = 0, scale = 0;
    for (int i = 0; i < 3; ++i) {
      const double a = frame.normal()[i] * low(i), b = frame.normal()[i] * high(i);
      most += std::max(a, b);
      scale += std::max(std::abs(a), std::abs(b));
    }
    const double nearest2 = min_distance2(from, box);
    // The second term makes up for what the sum may have lost.
    const double limit = most * frame.inverse_normal_length() * (1 + 0x1p-20) + 0x1p-40 * scale;
    return limit * limit < nearest2 ? limit / std::sqrt(nearest2) : 1;
  }

  /// Lower bound of l.v, in the same way. In [-1, 1].
  [[nodiscard]] double min_between_cosine_quickly() const {
    return least_cosine(frame.to_viewer(), frame.inverse_viewer_length());
  }

private:
  [[nodiscard]] double low(int i) const { return double(box.lo[i]) - from[i]; }
  [[nodiscard]] double high(int i) const { return double(box.hi[i]) - from[i]; }

  /// Lower bound of cos(u,l), rounding included.
  [[nodiscard]] double least_cosine(const glm::vec3& u, double inverse_length) const {
    double dot = 0, scale = 0, farthest2 = 0;
    for (int i = 0; i < 3; ++i) {
      const double far = std::max(std::abs(low(i)), std::abs(high(i)));
      dot += std::min(u[i] * low(i), u[i] * high(i));
      scale += std::abs(u[i]) * far;
      farthest2 += far * far;
    }
    // The second term makes up for what the sum may have lost.
    const double limit = (dot - 0x1p-48 * scale) * inverse_length;
    const double distance2 = limit >= 0 ? farthest2 : min_distance2(from, box);
    return limit * limit < distance2 ? limit / std::sqrt(distance2) : -1;
  }
};

/// Per channel: reflectance times what a lobe per reflectance makes of the light, not below 2^-700
/// where it is positive: products of that with floats do not underflow, and it vanishes beside
/// 2^-149 times whatever a float may be multiplied with. 0 times infinity is 0.
[[nodiscard]] inline glm::dvec3 lobe_bound(const glm::vec3& reflectance, double value) {
  glm::dvec3 result(0);
  const double kept = std::max(value, 0x1p-700);
  for (int c = 0; c < 3; ++c)
    if (reflectance[c] > 0) result[c] = reflectance[c] * kept;
  return result;
}

} // namespace lightcuts
