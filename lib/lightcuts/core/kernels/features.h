// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {

/// What a kernel is compiled for: the kinds of light that may occur, whether distances are clamped,
/// and whether anything may occlude. What is not among them costs nothing.
template <LightKinds Kinds, bool Clamps, bool Occludes>
struct Features {
  static constexpr LightKinds kinds = Kinds;
  static constexpr bool clamps = Clamps;
  static constexpr bool occludes = Occludes;

  /// Whether there may be lights of this kind.
  [[nodiscard]] static constexpr bool has(LightKind kind) { return (Kinds & only(kind)) != 0; }
  /// Whether all lights are of one kind.
  static constexpr bool uniform = (Kinds & (Kinds - 1)) == 0;
  /// Whether some lights shine differently in different directions.
  static constexpr bool has_axes = (Kinds & kinds_with_axis) != 0;

  /// The kind of something that is of `kind`: known at compile time where all are alike.
  [[nodiscard]] static constexpr LightKind known(LightKind kind) {
    if constexpr (!uniform) return kind;
    for (int k = 0; k < light_kind_count; ++k)
      if (has(LightKind(k))) return LightKind(k);
    return kind;
  }
};

/// Copes with every scene.
using AnyFeatures = Features<all_light_kinds, true, true>;

/// Calls f with the narrowest of the Features that are compiled: one kind of light alone or any.
template <class F>
decltype(auto) with_features(const LightSet& lights, bool occludes, F&& f) {
  const auto for_kinds = [&]<LightKinds kinds>() -> decltype(auto) {
    if constexpr (kinds != only(LightKind::directional))
      if (lights.min_distance() > 0)
        return occludes ? f(Features<kinds, true, true>()) : f(Features<kinds, true, false>());
    return occludes ? f(Features<kinds, false, true>()) : f(Features<kinds, false, false>());
  };
  switch (lights.kinds()) {
  case only(LightKind::omni):
    return for_kinds.template operator()<only(LightKind::omni)>();
  case only(LightKind::oriented):
    return for_kinds.template operator()<only(LightKind::oriented)>();
  case only(LightKind::spot):
    return for_kinds.template operator()<only(LightKind::spot)>();
  case only(LightKind::directional):
    return for_kinds.template operator()<only(LightKind::directional)>();
  default:
    return for_kinds.template operator()<all_light_kinds>();
  }
}

} // namespace lightcuts
