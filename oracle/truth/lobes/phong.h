// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <oracle/truth/lobes/lobe_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct LobeTruth<Phong> : UsualLobe {
  template <class Real>
  static Vector<Real> value(const Phong& phong, const Way<Real>& way) {
    using std::pow;
    const Real cosine = way.cosine_with(way.point.mirror());
    if (cosine <= 0) return {Real(0), Real(0), Real(0)};
    const Real value =
        (Real(phong.exponent) + 2) / (2 * pi<Real>()) * pow(cosine, Real(phong.exponent));
    return scaled(phong.reflectance, value);
  }
  static double largest(const Phong& phong, double /*viewer_cosine*/, int channel) {
    return phong.reflectance[channel] * peak(phong);
  }
  static Phong random(gen::Dice& dice) {
    const glm::vec3 reflectance = dice.reflectance();
    return {reflectance, dice.one_in(2)
                             ? dice.pick({0.0F, 1.0F, 10.0F, 1000.0F, 0x1p20F, 0.5F, 2.75F})
                             : std::min(std::abs(dice.log_uniform(-3, 6.03)), 0x1p20F)};
  }
  static Material white(const Phong& phong) { return {{}, Phong{glm::vec3(1), phong.exponent}}; }

  /// cos(r,l) = cos(r',v) for the mirror directions r of v and r' of l, but ShadingFrame rounds
  /// both to floats: each angle is off by up to mirror_error, so they differ by twice that at most.
  static glm::dvec3 input_rounding(const Phong& phong, const ShadingFrame& frame,
                                   const glm::vec3& l) {
    const glm::dvec3 r(frame.mirror()), d(l);
    const double angle = std::atan2(glm::length(glm::cross(r, d)), glm::dot(r, d));
    const auto lobe_at = [&](double a) {
      return peak(phong) * std::pow(std::max(0.0, std::cos(a)), double(phong.exponent));
    };
    constexpr double off = 2 * ShadingFrame::mirror_error;
    const double most = lobe_at(std::max(0.0, angle - off));
    const double least = angle + off < 0.5 * density::pi ? lobe_at(angle + off) : 0;
    return glm::dvec3(phong.reflectance) * (most - least);
  }

  /// p = (m + 1) cos(r,l)^m / (2 pi).
  class Density {
  public:
    Density(const Phong& phong, const ShadingFrame& frame)
        : r_(density::unit(frame.mirror())), side_{r_.z, 0, -r_.x}, m_(phong.exponent) {
      side_ = glm::normalize(side_); // the viewer is in the plane y = 0
    }
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
      const double versine = -std::expm1(std::log(at.x) / (m_ + 1)); // 1 - cos(r,l)
      const double sine = std::sqrt(versine * (2 - versine));
      const double angle = 2 * density::pi * at.y;
      return (1 - versine) * r_ +
             sine * (std::cos(angle) * side_ + std::sin(angle) * glm::cross(r_, side_));
    }
    [[nodiscard]] double operator()(const glm::dvec3& l) const {
      const double cosine = glm::dot(r_, l);
      return cosine <= 0 ? 0 : (m_ + 1) / (2 * density::pi) * std::pow(cosine, m_);
    }

  private:
    glm::dvec3 r_, side_;
    double m_;
  };

private:
  /// The largest f per reflectance.
  static double peak(const Phong& phong) {
    return (double(phong.exponent) + 2) / (2 * density::pi);
  }
};

} // namespace lightcuts::oracle::radiometry
