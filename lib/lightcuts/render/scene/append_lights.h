// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {

/// Adds the lights of `made` to `lights`; its clamp of distances does not count.
inline void append(const LightSet& made, LightSet& lights) {
  lights.reserve(lights.size() + made.size());
  for (const Light& light : made) lights.add(light);
}

} // namespace lightcuts
