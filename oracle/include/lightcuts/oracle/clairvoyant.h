// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <lightcuts/oracle/subject.h>
#include <lightcuts/oracle/truth.h>

namespace lightcuts::oracle {

/// Size of the clairvoyant cut: the smallest whose clusters' estimates all have a true error of at
/// most max(threshold x true total, black_level), per channel. Found top-down, accepting a cluster
/// as soon as it qualifies. truth: evaluated at the point with the same visibility.
[[nodiscard]] std::size_t clairvoyant_cut_size(const Subject& subject, const ShadingPoint& point,
                                               std::span<const char> visible, const Truth& truth,
                                               double threshold, double black_level);

} // namespace lightcuts::oracle
