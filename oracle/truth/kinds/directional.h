// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/truth/kinds/kind_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct KindTruth<LightKind::directional> : UsualKind {
  static constexpr bool is_far = true;

  static void finish(gen::Dice& dice, Light& light, const glm::vec3& /*x*/) {
    light.position = dice.unit_vector();
  }
};

} // namespace lightcuts::oracle::radiometry
