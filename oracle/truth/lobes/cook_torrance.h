// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <oracle/truth/lobes/half_vector.h>

namespace lightcuts::oracle::radiometry {

template <>
struct LobeTruth<CookTorrance> : UsualLobe {
  template <class Real>
  static Vector<Real> value(const CookTorrance& lobe, const Way<Real>& way) {
    Vector<Real> result{Real(0), Real(0), Real(0)};
    const Real viewer = viewer_cosine<Real>(way.point);
    if (viewer <= 0) return result;
    const Real a2 = Real(lobe.alpha) * Real(lobe.alpha);
    const Real t = half_tangent2(way);
    const Real ratio = (1 + t) / (a2 + t);
    const Real d = a2 / pi<Real>() * ratio * ratio;
    const Real l = way.n_dot_l;
    const Real v = 1 / (2 * (l * square_root<Real>(a2 + (1 - a2) * viewer * viewer) +
                             viewer * square_root<Real>(a2 + (1 - a2) * l * l)));
    const Real s = schlick(way);
    for (int c = 0; c < 3; ++c) {
      const Real f0(lobe.f0[c]);
      result[std::size_t(c)] = (f0 + (1 - f0) * s) * d * v;
    }
    return result;
  }
  /// D = 1 / (pi alpha^2) where h is the normal, V = 1 / (2 alpha n.v) where n.l is 0, F = 1.
  static double largest(const CookTorrance& lobe, double viewer_cosine, int /*channel*/) {
    if (viewer_cosine <= 0) return 0;
    const double a = lobe.alpha;
    return 1 / (density::pi * a * a) / (2 * a * viewer_cosine);
  }
  static CookTorrance random(gen::Dice& dice) {
    const glm::vec3 usual =
        dice.one_in(3) ? glm::vec3(0.04F) : gen::Dice::not_negative(dice.in_cube());
    const glm::vec3 f0 = dice.one_in(6) ? glm::vec3(0, 1, 0x1p-149F) : usual;
    return {f0, random_alpha(dice)};
  }
  static Material white(const CookTorrance& lobe) {
    return {{}, CookTorrance{glm::vec3(1), lobe.alpha}};
  }

  /// h is one of the normals of a GGX surface that v sees (Heitz 2018; the map is that of Dupuy and
  /// Benyoub 2023): p = G1 D / (4 n.v).
  class Density {
  public:
    Density(const CookTorrance& lobe, const ShadingFrame& frame)
        : v_(density::unit(frame.to_viewer())), alpha_(lobe.alpha),
          stretched_(glm::normalize(glm::dvec3(alpha_ * v_.x, alpha_ * v_.y, v_.z))) {}
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
      const double z = at.x * (1 + stretched_.z) - stretched_.z;
      const glm::dvec3 sum = density::around_z(z, 2 * density::pi * at.y) + stretched_;
      const glm::dvec3 h = glm::normalize(glm::dvec3(alpha_ * sum.x, alpha_ * sum.y, sum.z));
      return density::mirrored(v_, h);
    }
    [[nodiscard]] double operator()(const glm::dvec3& l) const {
      const double a2 = alpha_ * alpha_, t = density::tangent2(v_ + l);
      const double ratio = (1 + t) / (a2 + t);
      const double masked = v_.z + std::sqrt(a2 + (1 - a2) * v_.z * v_.z); // 2 n.v / G1
      return a2 * ratio * ratio / (2 * density::pi * masked);
    }

  private:
    glm::dvec3 v_;
    double alpha_;
    glm::dvec3 stretched_;
  };

private:
  template <class Real>
  static Real schlick(const Way<Real>& way) {
    if (!way.known_schlick) way.known_schlick = schlick_of(way);
    return *way.known_schlick;
  }

  /// (1 - v.h)^5 with v.h = cos(half the angle between l and v); in 700 bits where that angle is
  /// all but a right one, since the root of what is left of 1 + l.v magnifies its error.
  template <class Real>
  static Real schlick_of(const Way<Real>& way) {
    const glm::vec3& v = way.point.to_viewer();
    const Real cosine = way.cosine_with(v);
    const Real x = dot_between<Real>({0, -v.z, v.y}, way.from, way.to);
    const Real y = dot_between<Real>({v.z, 0, -v.x}, way.from, way.to);
    const Real z = dot_between<Real>({-v.y, v.x, 0}, way.from, way.to);
    const Real scale = length<Real>(v) * way.distance;
    const Real sine2 = (x * x + y * y + z * z) / (scale * scale);
    // 1 - cos without cancellation where the angle is acute.
    const Real versine = cosine > 0 ? Real(sine2 / (1 + cosine)) : Real(1 - cosine);
    const Real rest = versine > 2 ? Real(0) : Real(1 - versine / 2); // (v.h)^2
    if constexpr (!std::is_same_v<Real, Exact>)
      if (rest < Real(0x1p-20)) return Real(schlick_of(way.exact()));
    const Real w = (versine / 2) / (1 + square_root<Real>(rest));
    return w * w * w * w * w;
  }
};

} // namespace lightcuts::oracle::radiometry
