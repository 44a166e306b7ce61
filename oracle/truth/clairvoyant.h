// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include <glm/vec3.hpp>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {

/// Somebody's estimate of a cluster, by its node: radiance per channel, occlusion included.
using EstimateOfCluster = std::function<glm::dvec3(std::uint32_t)>;

/// Size of the clairvoyant cut: the smallest whose clusters' estimates all have a true error of at
/// most max(threshold x true total, black_level), per channel. Found top-down, accepting a cluster
/// as soon as it qualifies; no other cluster is asked for, and no leaf. truth: evaluated.
[[nodiscard]] std::size_t clairvoyant_cut_size(const Truth& truth,
                                               const EstimateOfCluster& estimate_of,
                                               double threshold, double black_level);

} // namespace lightcuts::oracle
