// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// Size of the clairvoyant cut: the smallest whose clusters' estimates all have a true error of at
/// most max(threshold x true total, black_level), per channel. Found top-down, accepting a cluster
/// as soon as it qualifies.
[[nodiscard]] std::size_t clairvoyant_cut_size(const Judged& judged, const PointCase& at,
                                               double threshold, double black_level);

} // namespace lightcuts::oracle
