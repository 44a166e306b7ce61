// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/lighting/kinds/directional.h>
#include <lightcuts/render/lighting/kinds/omni.h>
#include <lightcuts/render/lighting/kinds/oriented.h>
#include <lightcuts/render/lighting/kinds/profile.h>
#include <lightcuts/render/lighting/kinds/spot.h>

namespace lightcuts {

/// f(KindInScenes<kind>()).
template <int first = 0, class F>
auto with_kind_in_scenes(LightKind kind, F&& f) {
  if constexpr (first + 1 < light_kind_count)
    if (kind != LightKind(first)) return with_kind_in_scenes<first + 1>(kind, f);
  return f(KindInScenes<LightKind(first)>());
}

} // namespace lightcuts
