// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <oracle/truth/lobes/lobe_truth.h>

namespace lightcuts::oracle::radiometry {

template <>
struct LobeTruth<NoLobe> : UsualLobe {
  template <class Real>
  static Vector<Real> value(const NoLobe& /*lobe*/, const Way<Real>& /*way*/) {
    return {Real(0), Real(0), Real(0)};
  }
  static double largest(const NoLobe& /*lobe*/, double /*viewer_cosine*/, int /*channel*/) {
    return 0;
  }
  static NoLobe random(gen::Dice& /*dice*/) { return {}; }

  /// The diffuse part.
  static Material white(const NoLobe& lobe) { return {glm::vec3(1), lobe}; }

  /// p = n.l / pi.
  struct Density {
    Density(const NoLobe& /*lobe*/, const ShadingFrame& /*frame*/) {}
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& at) const {
      return density::around_z(std::sqrt(at.x), 2 * density::pi * at.y);
    }
    [[nodiscard]] double operator()(const glm::dvec3& l) const { return l.z / density::pi; }
  };
};

} // namespace lightcuts::oracle::radiometry
