// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>
#include <lightcuts/core/lights/profile.h>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {

/// How a light spreads its power. theta is the angle between Light::axis and the direction in which
/// light leaves, d the distance to the light.
enum class LightKind : std::uint8_t {
  omni,     ///< intensity / d^2: alike in all directions
  oriented, ///< intensity max(0, cos theta) / d^2: a piece of a surface, a VPL
  spot,     ///< intensity t^2 / d^2, t = (cos theta - cos_outer) / (cos_inner - cos_outer) clamped
            ///< to [0, 1]: a cone with a soft rim, as in glTF's KHR_lights_punctual
  directional, ///< intensity, whatever the distance: so far away that all its rays are parallel
  profile      ///< intensity share / d^2: a luminaire by its measured table, see ProfileTable
};
inline constexpr int light_kind_count = 5;
[[nodiscard]] constexpr std::array<const char*, light_kind_count> names_of(LightKind /*any*/) {
  return {"omni", "oriented", "spot", "directional", "profile"};
}

/// A set of kinds: bit k stands for LightKind(k).
using LightKinds = unsigned;
[[nodiscard]] constexpr LightKinds only(LightKind kind) { return 1U << unsigned(kind); }
inline constexpr LightKinds all_light_kinds = (1U << unsigned(light_kind_count)) - 1;
inline constexpr LightKinds kinds_with_axis =
    only(LightKind::oriented) | only(LightKind::spot) | only(LightKind::profile);

/// Whether Light::axis counts.
[[nodiscard]] constexpr bool has_axis(LightKind kind) {
  return (only(kind) & kinds_with_axis) != 0;
}
/// Whether Light::position is a direction, from which light comes in parallel rays.
[[nodiscard]] constexpr bool is_at_infinity(LightKind kind) {
  return kind == LightKind::directional;
}

/// A light without extent. Its floats are taken as exact real numbers; the length of a direction is
/// divided out wherever it is used.
struct Light {
  LightKind kind = LightKind::omni;
  glm::vec3 position{0};  ///< metres; of a directional light: the unit direction towards it
  glm::vec3 intensity{0}; ///< radiant intensity along the axis, W/sr, each >= 0; of a profile:
                          ///< where its share is 1; of a directional light: irradiance of a surface
                          ///< that faces it, W/m^2
  glm::vec3 axis{0};      ///< unit, where most of an oriented or spot light goes, and vertical
                          ///< angle 0 of a profile; else unused
  float cos_inner = 1;    ///< of a spot: full intensity within, more than cos_outer
  float cos_outer = -1;   ///< of a spot: nothing beyond; a little below -1 for a rim of some width
  glm::vec3 plane{0}; ///< of a profile: unit, horizontal angle 0, about perpendicular to the axis
  Profile profile;    ///< of a profile: what goes where

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("kind", &Light::kind);
    field("position", &Light::position, [](const Light& light) {
      return is_at_infinity(light.kind) ? domain::unit : domain::any;
    });
    field("intensity", &Light::intensity, domain::not_negative);
    field("axis", &Light::axis,
          [](const Light& light) { return has_axis(light.kind) ? domain::unit : domain::absent; });
    field("cos_inner", &Light::cos_inner, [](const Light& light) {
      return light.kind == LightKind::spot ? domain::within(-1, 1) : domain::absent;
    });
    field("cos_outer", &Light::cos_outer, [](const Light& light) {
      return light.kind == LightKind::spot ? domain::within(-1 - 0x1p-10, 1) : domain::absent;
    });
    const auto of_profile = [](Domain domain) {
      return [domain](const Light& light) {
        return light.kind == LightKind::profile ? domain : domain::absent;
      };
    };
    field("plane", &Light::plane, of_profile(domain::unit));
    field("profile", &Light::profile, of_profile(domain::any));
  }
  bool operator==(const Light&) const = default;
};

/// From where a light is looked at: one at infinity lies at its direction as seen from 0.
[[nodiscard]] constexpr glm::vec3 viewed_from(LightKind kind, const glm::vec3& x) {
  return is_at_infinity(kind) ? glm::vec3(0) : x;
}

} // namespace lightcuts
