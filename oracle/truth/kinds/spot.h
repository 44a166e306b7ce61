// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

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
  }
};

} // namespace lightcuts::oracle::radiometry
