// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/lobes/material.h>
#include <oracle/numbers/dice.h>
#include <oracle/truth/lobes/direction_density.h>
#include <oracle/truth/way.h>

namespace lightcuts::oracle::radiometry {

/// What a lobe is by its definition, written without the lobe's own formulas, and what it takes to
/// judge it:
///   value(lobe, way)            f, 1/sr per channel, for any type of number;
///   largest(lobe, n.v, channel) f n.l at most, whatever the direction of the light;
///   random(dice)                a lobe of the domain's middle or ends;
///   white(lobe)                 a material that is this lobe alone, reflecting all that it can;
///   Density(lobe, frame)        a map from the unit square to directions l, direction(at), and
///                               their density p(l), operator()(l), which is about that of f n.l,
///                               for frames of normal (0, 0, 1); l is a unit vector;
/// and what UsualLobe has, where it is not so.
template <class OneLobe>
struct LobeTruth {
  static_assert(sizeof(OneLobe) == 0,
                "a lobe without its truth: write oracle/truth/lobes/<lobe>.h, and include it in "
                "oracle/truth/lobes.h");
};

/// Reflects at most all light, and has only inputs that are exact.
struct UsualLobe {
  /// The share of the light from one direction that the definition allows to be reflected.
  template <class OneLobe>
  static double most_reflected(const OneLobe& /*lobe*/, double /*viewer_cosine*/) {
    return 1;
  }
  /// How far f with light from l and f with light and viewer exchanged may differ, which are equal
  /// by definition, apart from the error of evaluating them.
  template <class OneLobe>
  static glm::dvec3 input_rounding(const OneLobe& /*lobe*/, const ShadingFrame& /*frame*/,
                                   const glm::vec3& /*l*/) {
    return glm::dvec3(0);
  }
};

} // namespace lightcuts::oracle::radiometry
