// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <lightcuts/core/lights/light.h>
#include <lightcuts/core/lobes/material.h>

namespace lightcuts::oracle {

inline constexpr const char* counterexample_schema = "lightcuts-oracle/counterexample/1";

/// In the order of LightKind.
inline constexpr std::array<const char*, light_kind_count> light_kind_names{"omni", "oriented",
                                                                            "spot", "directional"};
/// In the order of Lobe.
inline constexpr std::array lobe_names{"none", "phong", "ward", "cook-torrance"};

[[nodiscard]] constexpr const char* name_of(LightKind kind) {
  return light_kind_names[std::size_t(kind)];
}
[[nodiscard]] inline const char* name_of(const Lobe& lobe) { return lobe_names[lobe.index()]; }

} // namespace lightcuts::oracle
