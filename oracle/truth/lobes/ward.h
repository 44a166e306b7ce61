// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <oracle/truth/lobes/half_vector.h>

namespace lightcuts::oracle::radiometry {

template <>
struct LobeTruth<Ward> : UsualLobe {
  template <class Real>
  static Vector<Real> value(const Ward& ward, const Way<Real>& way) {
    using std::exp;
    const Real viewer = viewer_cosine<Real>(way.point);
    if (viewer <= 0) return {Real(0), Real(0), Real(0)};
    const Real a2 = Real(ward.alpha) * Real(ward.alpha);
    const Real value = exp(-half_tangent2(way) / a2) /
                       (4 * pi<Real>() * a2 * square_root<Real>(way.n_dot_l * viewer));
    return scaled(ward.reflectance, value);
  }
  static double largest(const Ward& ward, double viewer_cosine, int channel) {
    if (viewer_cosine <= 0) return 0;
    const double a2 = double(ward.alpha) * ward.alpha;
    return ward.reflectance[channel] / (4 * density::pi * a2 * std::sqrt(viewer_cosine));
  }
  static Ward random(gen::Dice& dice) {
    const glm::vec3 reflectance = dice.reflectance();
    return {reflectance, random_alpha(dice)};
  }
  static Material white(const Ward& ward) { return {{}, Ward{glm::vec3(1), ward.alpha}}; }

  /// There is no limit near the horizon; see Ward. The smaller factor is that of small alpha.
  static double most_reflected(const Ward& ward, double viewer_cosine) {
    const double factor = std::min(0.068, 0.37 * ward.alpha * std::sqrt(double(ward.alpha)));
    return std::max(1.0, factor / std::sqrt(viewer_cosine));
  }

  /// The slopes of h have a normal distribution: with dl = 4 v.h dh,
  /// p = exp(-tan^2(n,h) / alpha^2) / (4 pi alpha^2 cos^3(n,h) v.h).
  class Density {
  public:
    Density(const Ward& ward, const ShadingFrame& frame)
        : v_(density::unit(frame.to_viewer())), alpha_(ward.alpha) {}
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
      const double slope = alpha_ * std::sqrt(-std::log(at.x));
      const glm::dvec3 h =
          density::around_z(1 / std::sqrt(1 + slope * slope), 2 * density::pi * at.y);
      // Mirrored at the back of h there is no light.
      return glm::dot(v_, h) <= 0 ? glm::dvec3(0, 0, -1) : density::mirrored(v_, h);
    }
    [[nodiscard]] double operator()(const glm::dvec3& l) const {
      const glm::dvec3 h = glm::normalize(v_ + l);
      const double a2 = alpha_ * alpha_;
      return std::exp(-density::tangent2(h) / a2) /
             (4 * density::pi * a2 * h.z * h.z * h.z * glm::dot(v_, h));
    }

  private:
    glm::dvec3 v_;
    double alpha_;
  };
};

} // namespace lightcuts::oracle::radiometry
