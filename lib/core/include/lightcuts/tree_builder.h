// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/light_set.h>
#include <lightcuts/light_tree.h>

namespace lightcuts {

struct BuildConfig {
  std::uint64_t seed = 1; ///< of the random choice of representatives; default 1
};

/// Builds the tree that greedy bottom-up clustering defines (Walter et al. 2005, section 3.1):
/// merge again and again the two clusters whose union has the least
///   (sum of intensity over the channels) ((diagonal of the box)^2 + c^2 (1 - cos beta)^2) ,
/// the pair with the lowest light indices among equals. beta is the half-angle of a cone around the
/// lights' axes (measured by a box of axes; 0 without axes), c the diagonal of all lights. Lights
/// of each kind are clustered among themselves, directional ones by the box of their directions;
/// the clusters of the kinds are joined last. Nearest-neighbour chains over a k-d tree find it in
/// near-linear time (Walter et al. 2008, "Fast Agglomerative Clustering for Rendering"); naive
/// search gives the same tree. A cluster's representative is that of one of its children, with
/// probability proportional to their intensities.
[[nodiscard]] LightTree build(const LightSet& lights, const BuildConfig& config = {});

} // namespace lightcuts
