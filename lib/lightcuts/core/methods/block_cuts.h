// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/methods/method.h>

namespace lightcuts::methods {

inline constexpr MethodDescription block_cuts{
    .name = "block-cuts",
    .meaning = "Cuts that neighbouring pixels share, each asking for other lights of a cluster.",
    .draws = true,
    .cuts = true,
    .rules = {},
    .lighter = lighter_by_blocks};

} // namespace lightcuts::methods
