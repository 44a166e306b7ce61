// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <lightcuts/oracle/properties.h>
#include <lightcuts/oracle/subject.h>
#include <lightcuts/oracle/truth.h>

namespace lightcuts::oracle {

/// A shading point with all that is true there.
struct PointCase {
  std::uint64_t place; ///< orders violations
  const ShadingPoint& point;
  std::span<const char> visible; ///< per light, whether it is seen
  const Truth& truth;            ///< evaluated for this point and visibility
};

/// Checks every cluster of the subject's tree at the point: bound-dominates-contribution,
/// bound-dominates-error, bound-shrinks-on-refinement, results-are-finite.
void check_clusters(const Subject& subject, const PointCase& at, Tally& tally);

/// Checks one cut: cut-partitions-lights, cut-obeys-threshold, certified-error-holds,
/// total-does-not-drift, results-are-finite; with a threshold of 0, no black level and a size
/// for all lights, zero-threshold-is-exact too.
void check_cut(const Subject& subject, const CutConfig& config, const Cut& cut, const PointCase& at,
               Tally& tally);

/// Checks the material at the point with light from the direction of `light`, if that is above the
/// horizon: brdf-is-reciprocal.
void check_reciprocity(const PointCase& at, const Light& light, Tally& tally);

/// Checks one part of materials, seen from several angles: brdf-conserves-energy. Reflectances do
/// not matter.
void check_energy(const Lobe& lobe, std::uint64_t place, Tally& tally);

/// Checks the tree itself: tree-conserves-intensity, representative-belongs.
void check_tree(const LightTree& tree, Tally& tally);

} // namespace lightcuts::oracle
