// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/numerics/exact_dot.h>
#include <lightcuts/core/shading/shading_frame.h>

namespace lightcuts {

/// A light seen from a shading point: what lobes are evaluated with. q = to - from, l = q/|q|, n
/// the normal, v the direction to the viewer, h the direction of l + v.
class Sight {
public:
  /// The sight of something of this kind at `to`; see Light::position.
  Sight(const ShadingFrame& frame, LightKind kind, const glm::vec3& to)
      : frame_(frame), from_(viewed_from(kind, frame.position())), to_(to),
        q_(glm::dvec3(to) - glm::dvec3(from_)),
        n_dot_q_(dot_between(frame.normal(), from_, to) * frame.inverse_normal_length()),
        distance2_(q_.x * q_.x + q_.y * q_.y + q_.z * q_.z), distance_(std::sqrt(distance2_)) {}

  [[nodiscard]] const ShadingFrame& frame() const { return frame_; }
  [[nodiscard]] const glm::dvec3& q() const { return q_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] double distance2() const { return distance2_; }

  /// Whether the light is below the surface's horizon, or on it; or at the very point.
  [[nodiscard]] bool below_horizon() const { return n_dot_q_ <= 0; }
  /// n.l; relative error 2^-34, zero and sign exact. Not below the horizon.
  [[nodiscard]] double cosine() const { return n_dot_q_ / distance_; }
  /// cos(r,l), r the mirror direction as ShadingFrame has it; errors as of cosine().
  [[nodiscard]] double mirror_cosine() const {
    return dot_between(frame_.mirror(), from_, to_) * frame_.inverse_mirror_length() / distance_;
  }

  /// tan^2(n,h), for lights and viewers above the horizon, never NaN: with the parts of l and v
  /// along the surface |l_t + v_t|^2 / (n.l + n.v)^2. That loses the digits of l and v where they
  /// are all but opposite; there it is found without their sum.
  ///
  /// Error of the tangent T up to 700^0.5, beyond which no lobe tells it from infinity: 2^-47.2,
  /// and 2^-41 T. The sum is 1/4 or more, and errs by 10 roundings of 2^-53, and by 12 of its
  /// length; n.l and n.v err by 2^-51 each, and their sum is 2^-2.2 or more up to T = 1/2, 2^-6.8
  /// beyond.
  [[nodiscard]] double half_tangent2() const {
    const glm::dvec3 n = glm::dvec3(frame_.normal()) * frame_.inverse_normal_length();
    const glm::dvec3 sum = half_vector();
    const double sum2 = glm::dot(sum, sum);
    if (sum2 < 0x1p-4) [[unlikely]]
      return half_tangent2_of_opposites(sum2);
    const glm::dvec3 along = sum - glm::dot(n, sum) * n;
    const double up = cosine() + frame_.viewer_cosine();
    return glm::dot(along, along) / (up * up);
  }

  /// Schlick's (1 - v.h)^5, relative error 2^-31 however close l and v are, or -l and v.
  [[nodiscard]] double schlick() const {
    const glm::vec3& v = frame_.to_viewer();
    // The parts of v x q, each as a dot product that does not lose its digits.
    const double x = dot_between({0, -v.z, v.y}, from_, to_);
    const double y = dot_between({v.z, 0, -v.x}, from_, to_);
    const double z = dot_between({-v.y, v.x, 0}, from_, to_);
    const double scale = frame_.inverse_viewer_length() / distance_;
    const double cosine =
        std::clamp(dot_between(v, from_, to_) * scale, -1.0, 1.0); // between l and v
    // v.h, by way of |l + v| = 2 v.h where the root would magnify the error of the cosine.
    const double half_cosine =
        cosine < -1 + 0x1p-20 ? 0.5 * glm::length(half_vector()) : std::sqrt(0.5 * (1 + cosine));
    const double sine2 = (x * x + y * y + z * z) * scale * scale;
    const double w = cosine > 0 ? sine2 / (2 * (1 + cosine) * (1 + half_cosine)) : 1 - half_cosine;
    return w * w * (w * w) * w;
  }

private:
  /// l + v.
  [[nodiscard]] glm::dvec3 half_vector() const {
    const glm::dvec3 v = glm::dvec3(frame_.to_viewer()) * frame_.inverse_viewer_length();
    return q_ / distance_ + v;
  }
  /// half_tangent2() where |l + v|^2 is below 2^-4. The tangent T errs by 2^-50, and by 2^-41 T.
  [[nodiscard]] double half_tangent2_of_opposites(double sum2) const;

  const ShadingFrame& frame_;
  glm::vec3 from_, to_;
  glm::dvec3 q_;
  double n_dot_q_, distance2_, distance_;
};

} // namespace lightcuts
