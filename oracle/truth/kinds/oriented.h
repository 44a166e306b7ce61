// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct KindTruth<LightKind::oriented> : UsualKind {
  template <class Real>
  static Real emission(const Light& light, const glm::vec3& x, const Real& distance) {
    const Real cosine = axis_cosine(light, x, distance);
    return cosine > 0 ? cosine : Real(0);
  }
  static void finish(gen::Dice& dice, Light& light, const glm::vec3& x) {
    light.axis = dice.direction(light.position, x);
  }
};

} // namespace lightcuts::oracle::radiometry
