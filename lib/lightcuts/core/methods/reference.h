// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription reference{.name = "reference",
                                             .meaning =
                                                 "Every light on its own: exact but for rounding.",
                                             .draws = false,
                                             .cuts = false,
                                             .rules = {},
                                             .lighter = lighter_by_sums};

} // namespace lightcuts::methods
