// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include <lightcuts/core/jobs/progress.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/tree/light_tree.h>

namespace lightcuts {

/// How build() chooses which clusters to merge.
enum class Builder {
  greedy,         ///< the cheapest pair of all each time
  locally_ordered ///< pairs that are near on a Morton curve, many at once
};

inline constexpr Builder all_builders[] = {Builder::greedy, Builder::locally_ordered};

[[nodiscard]] constexpr std::array<const char*, 2> names_of(Builder /*any*/) {
  return {"greedy", "locally-ordered"};
}

struct BuildConfig {
  std::uint64_t seed = 1; ///< of the random choice of representatives; default 1
  Builder builder = Builder::greedy;
  Progress progress; ///< asked whether to leave it, at first and every 1024 merges at least; told
                     ///< nothing
};

/// Builds a tree by bottom-up clustering (Walter et al. 2005, section 3.1). Merging two clusters
/// costs
///   (sum of intensity over the channels) ((diagonal of the box)^2 + c^2 (1 - cos beta)^2) ,
/// beta being the half-angle of a cone around the lights' axes (measured by a box of axes; 0
/// without axes), c the diagonal of all lights. Lights of each kind are clustered among themselves,
/// directional ones by the box of their directions; the clusters of the kinds are joined last. A
/// cluster's representative is that of one of its children, with probability proportional to their
/// intensities.
///
/// Builder::greedy merges lights of the same position and axis first, in halves by index, so that
/// many at one place make a balanced tree; then again and again the cheapest of all pairs, that
/// with the lowest light indices among equals. Nearest-neighbour chains over a k-d tree find that
/// tree in near-linear time (Walter et al. 2008, "Fast Agglomerative Clustering for Rendering");
/// naive search gives the same.
///
/// Builder::locally_ordered is parallel locally-ordered clustering (Meister and Bittner 2018): in
/// rounds, each cluster looks for its cheapest partner among eight neighbours on a Morton curve,
/// and those that choose each other merge. Near-linear time, whatever the lights.
///
/// Throws InputError for more than 2^31 lights, and Cancelled.
[[nodiscard]] LightTree build(const LightSet& lights, const BuildConfig& config = {});

} // namespace lightcuts
