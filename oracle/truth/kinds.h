// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/truth/kinds/directional.h>
#include <oracle/truth/kinds/omni.h>
#include <oracle/truth/kinds/oriented.h>
#include <oracle/truth/kinds/profile.h>
#include <oracle/truth/kinds/spot.h>

namespace lightcuts::oracle::radiometry {

/// f(KindTruth<kind>()).
template <int first = 0, class F>
auto with_kind(LightKind kind, F&& f) {
  if constexpr (first + 1 < light_kind_count)
    if (kind != LightKind(first)) return with_kind<first + 1>(kind, f);
  return f(KindTruth<LightKind(first)>());
}

[[nodiscard]] inline bool is_far(LightKind kind) {
  return with_kind(kind, [](auto truth) { return truth.is_far; });
}

} // namespace lightcuts::oracle::radiometry
