// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace lightcuts {

inline constexpr float inf = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float largest_float = std::numeric_limits<float>::max();
inline constexpr float smallest_float = std::numeric_limits<float>::denorm_min();

} // namespace lightcuts
