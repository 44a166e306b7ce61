// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <lightcuts/core/records/fields.h>
#include <lightcuts/render/images/colour_map.h>

namespace lightcuts::viz {

/// How values become colours.
struct ColourSettings {
  ColourMap map = ColourMap::inferno;
  bool logarithmic = false;
  bool automatic_range = true;
  float lo = 0, hi = 1;          ///< where not automatic; lo < hi, and 0 < lo if logarithmic
  std::optional<float> exposure; ///< of images: a factor; nothing: automatic_exposure()

  bool operator==(const ColourSettings&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    constexpr Domain exposure{.least = 1e-30, .most = 1e30, .optional = true};
    field("colour_map", &ColourSettings::map, domain::optional);
    field("logarithmic", &ColourSettings::logarithmic, domain::optional);
    field("automatic_range", &ColourSettings::automatic_range, domain::optional);
    field("lo", &ColourSettings::lo, domain::optional);
    field("hi", &ColourSettings::hi, domain::optional);
    field("exposure", &ColourSettings::exposure, exposure);
  }
};

} // namespace lightcuts::viz
