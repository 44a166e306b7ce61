// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct KindTruth<LightKind::spot> : UsualKind {
  template <class Real>
  static Real emission(const Light& light, const glm::vec3& x, const Real& distance) {
    const Real rim = beyond_cosine(light, x, axis_cosine(light, x, distance), light.cos_outer);
    const Real t = rim / (Real(light.cos_inner) - Real(light.cos_outer));
    if (t <= 0) return Real(0);
    return t >= 1 ? Real(1) : Real(t * t);
  }
  static void finish(gen::Dice& dice, Light& light, const glm::vec3& x) {
    light.axis = dice.direction(light.position, x);
    light.cos_inner = float(dice.uniform(-0.9, 1));
    light.cos_outer = float(dice.uniform(-1, light.cos_inner - 0x1p-10));
    if (dice.one_in(4)) light.cos_outer = std::min(0.0F, light.cos_inner - 0x1p-10F);
    gen::Dice rim = dice.aside();
    if (rim.one_in(3)) narrow(rim, light, x);
  }

private:
  /// A cone or a rim as narrow as floats can say: of these angles, the inner one equal to the outer
  /// or nearly; one float's step, anywhere; or a ramp that x lies on.
  static void narrow(gen::Dice& dice, Light& light, const glm::vec3& x) {
    const int what = dice.below(3);
    if (what == 2 && on_ramp(dice, light, x)) return;
    if (what == 0) {
      const double degrees =
          dice.pick({0.001, 0.02, 0.03, 0.5, 1.0, 30.0, 60.0, 90.0, 179.0, 180.0});
      const double outer = degrees * (std::numbers::pi / 180);
      light.cos_outer = float(std::cos(outer));
      light.cos_inner = float(std::cos(outer * dice.pick({1.0, 1.0, 1 - 0x1p-20, 0.99, 0.0})));
    } else {
      light.cos_inner = dice.one_in(2) ? float(dice.uniform(-0.99, 1))
                                       : dice.pick({1.0F, 0x1.fffffep-1F, 0.0F, 0x1p-149F,
                                                    0x1p-126F, -0x1p-149F, 0.5F, -0x1.fffffep-1F});
      light.cos_outer = light.cos_inner;
    }
    light.cos_inner = std::max(light.cos_inner, std::nextafter(-1.0F, 0.0F));
    light.cos_outer = std::min(light.cos_outer, std::nextafter(light.cos_inner, -2.0F));
  }

  /// Not nearer to either end of the ramp than a cosine in doubles can tell, so that whoever
  /// computes it like that is right to a float's last digit.
  static bool on_ramp(gen::Dice& dice, Light& light, const glm::vec3& x) {
    const glm::dvec3 way = glm::dvec3(x) - glm::dvec3(light.position), axis(light.axis);
    const double cosine =
        glm::dot(axis, way) / std::sqrt(glm::dot(way, way) * glm::dot(axis, axis));
    const double width = std::ldexp(1.0, -dice.between(8, 24));
    const auto outer = float(cosine - dice.uniform(0.25, 0.75) * width);
    const auto inner = std::max(float(outer + width), std::nextafter(outer, 2.0F));
    if (!(cosine - outer >= 0x1p-26 && std::abs(inner - cosine) >= 0x1p-26)) return false;
    if (outer < -1 || inner > 1) return false;
    light.cos_outer = outer;
    light.cos_inner = inner;
    return true;
  }
};

} // namespace lightcuts::oracle::radiometry
