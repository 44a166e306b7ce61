// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <oracle/properties/properties.h>
#include <oracle/subjects/subject.h>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {

/// A shading point with all that is true there.
struct PointCase {
  std::uint64_t place; ///< orders violations
  const ShadingPoint& point;
  std::span<const char> visible; ///< per light, whether it is seen
  const Truth& truth;            ///< evaluated for this point and visibility

  [[nodiscard]] const Topology& topology() const { return truth.topology(); }
  [[nodiscard]] const LightSet& lights() const { return truth.lights(); }
};

/// A subject's tree, and which parts of it can be judged.
struct Judged {
  SubjectTree& tree;
  Parts parts;

  [[nodiscard]] bool has(Part part) const { return oracle::has(parts, part); }
};

/// The subject's estimate of a cluster, occlusion included; a representative below the horizon
/// counts as seen, and so does one that the subject does not name.
[[nodiscard]] glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node,
                                       const PointCase& at, const glm::vec3& bound);

/// Checks one cluster of the subject's tree at the point, given the bounds of all:
/// bound-dominates-contribution, bound-dominates-error, bounds-are-ordered,
/// bound-shrinks-on-refinement, bound-is-finite, results-are-finite, as far as the parts go.
void check_cluster(const Judged& judged, std::uint32_t node, const PointCase& at,
                   std::span<const glm::vec3> bounds, Tally& tally);

/// The same for every cluster, if bounds can be judged.
void check_clusters(const Judged& judged, const PointCase& at, Tally& tally);

/// bound-dominates-contribution for one cluster, without a Truth.
void check_bound(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                 std::uint64_t place, std::uint32_t node, const glm::vec3& bound, Tally& tally);

/// Checks one cut: cut-partitions-lights, cut-obeys-threshold, certified-error-holds,
/// total-does-not-drift, results-are-finite; with a threshold of 0, no black level and a size
/// for all lights, zero-threshold-is-exact too.
void check_cut(const Judged& judged, const CutConfig& config, const Cut& cut, const PointCase& at,
               Tally& tally);

/// Checks the material at the point with light from the direction of `light`, if that is above the
/// horizon: brdf-is-reciprocal.
void check_reciprocity(const PointCase& at, const Light& light, Tally& tally);

/// Checks one part of materials, seen from several angles: brdf-conserves-energy. Reflectances do
/// not matter.
void check_energy(const Lobe& lobe, std::uint64_t place, Tally& tally);

/// Checks the tree itself: tree-partitions-lights, tree-conserves-intensity,
/// representative-belongs. Nothing where it is no tree.
[[nodiscard]] std::optional<Topology> check_tree(TreeClaim claim, const LightSet& lights,
                                                 std::uint64_t place, Tally& tally);

} // namespace lightcuts::oracle
