// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/light.h>
#include <oracle/numbers/dice.h>
#include <oracle/truth/vectors.h>

namespace lightcuts::oracle::radiometry {

/// What a light of this kind is by its definition, and how to draw one at random:
///   is_far                      whether its position is a direction, and distance means nothing;
///   emission(light, x, |q|)     the share of its intensity that it sends to x, any type of number;
///   finish(dice, light, x)      draws what it has apart from kind, position and intensity;
/// where it differs from UsualKind.
template <LightKind kind>
struct KindTruth {
  static_assert(kind == LightKind(-1),
                "a light kind without its truth: write oracle/truth/kinds/<kind>.h, and include it "
                "in oracle/truth/kinds.h");
};

/// Shines alike in all directions.
struct UsualKind {
  static constexpr bool is_far = false;

  template <class Real>
  static Real emission(const Light& /*light*/, const glm::vec3& /*x*/, const Real& /*distance*/) {
    return Real(1);
  }
  static void finish(gen::Dice& /*dice*/, Light& /*light*/, const glm::vec3& /*x*/) {}
};

/// Of a light with an axis: the cosine between the axis and the way to x.
template <class Real>
Real axis_cosine(const Light& light, const glm::vec3& x, const Real& distance) {
  return dot_between<Real>(light.axis, light.position, x) / (length<Real>(light.axis) * distance);
}

/// cosine, which is axis_cosine(), less that of a rim; where that cancels, in 700 bits.
template <class Real>
Real beyond_cosine(const Light& light, const glm::vec3& x, const Real& cosine, float rim) {
  const Real beyond = cosine - Real(rim);
  if constexpr (!std::is_same_v<Real, Exact>) {
    if (beyond < Real(0x1p-20) && beyond > Real(-0x1p-20)) {
      const Exact dot = dot_of_floats(light.axis, light.position, x);
      Exact distance2 = 0;
      for (int i = 0; i < 3; ++i) {
        const Exact d = Exact(x[i]) - Exact(light.position[i]);
        distance2 += d * d;
      }
      const Exact exact = dot / (length<Exact>(light.axis) * square_root<Exact>(distance2));
      return Real(Exact(exact - Exact(rim)));
    }
  }
  return beyond;
}

} // namespace lightcuts::oracle::radiometry
