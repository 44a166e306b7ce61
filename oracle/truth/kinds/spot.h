// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct KindTruth<LightKind::spot> : UsualKind {
  template <class Real>
  static Real emission(const Light& light, const glm::vec3& x, const Real& distance) {
    const Real rim = beyond_rim(light, x, axis_cosine(light, x, distance));
    const Real t = rim / (Real(light.cos_inner) - Real(light.cos_outer));
    if (t <= 0) return Real(0);
    return t >= 1 ? Real(1) : Real(t * t);
  }
  static void finish(gen::Dice& dice, Light& light, const glm::vec3& x) {
    light.axis = dice.direction(light.position, x);
    light.cos_inner = float(dice.uniform(-0.9, 1));
    light.cos_outer = float(dice.uniform(-1, light.cos_inner - 0x1p-10));
    if (dice.one_in(4)) light.cos_outer = std::min(0.0F, light.cos_inner - 0x1p-10F);
  }

private:
  /// cosine - cos_outer; where that cancels, in 700 bits.
  template <class Real>
  static Real beyond_rim(const Light& light, const glm::vec3& x, const Real& cosine) {
    const Real rim = cosine - Real(light.cos_outer);
    if constexpr (!std::is_same_v<Real, Exact>) {
      if (rim < Real(0x1p-20) && rim > Real(-0x1p-20)) {
        const Exact dot = dot_of_floats(light.axis, light.position, x);
        Exact distance2 = 0;
        for (int i = 0; i < 3; ++i) {
          const Exact d = Exact(x[i]) - Exact(light.position[i]);
          distance2 += d * d;
        }
        const Exact exact = dot / (length<Exact>(light.axis) * square_root<Exact>(distance2));
        return Real(Exact(exact - Exact(light.cos_outer)));
      }
    }
    return rim;
  }
};

} // namespace lightcuts::oracle::radiometry
