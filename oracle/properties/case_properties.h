// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/view/scene_view.h>
#include <oracle/cases/case.h>
#include <oracle/properties/point_properties.h>

namespace lightcuts::oracle {

/// Compares the tree with that of greedy clustering, where lights are few and of one kind:
/// tree-equals-naive.
void check_cost(const Topology& topology, const LightSet& lights, std::uint64_t place,
                Tally& tally);

/// Compares cuts of two thresholds, without a black level: tighter-threshold-refines.
void check_nesting(const Judged& judged, const CutConfig& cut, const PointCase& at, Tally& tally);

/// Compares exact cuts with and without occlusion: visibility-only-darkens.
void check_darkening(const Judged& judged, const PointCase& at, Tally& tally);

/// Asks for the order of a few bounds, infinity and NaN-free ties among them:
/// refinement-order-is-strict.
void check_refinement_order(const Subject& subject, std::uint64_t place, Tally& tally);

/// Asks everything twice, and another thread's copy of the tree: threads-agree.
void check_agreement(const Judged& judged, const CutConfig& cut, const PointCase& at, Tally& tally);

/// Checks the probabilities of all lights of all clusters, without drawing many:
/// probabilities-sum-to-one, contributing-lights-are-drawn, draws-state-their-probability.
void check_probabilities(const Judged& judged, const PointCase& at, Tally& tally);

/// Draws so many lights that, all cases of a run taken together, the chance of any false alarm is
/// at most false_alarms (each test has its Sidak share), and a bias of 1 % of the mean in any
/// channel, and a light that is drawn with a probability 0.05 off, each go unnoticed with a
/// probability of at most 0.001: stochastic-is-unbiased, draws-follow-probabilities, and
/// draws-are-independent, which is tested with the same draws and states no power. Nothing where
/// that takes more than max_draws. cases: how many calls share false_alarms.
struct DrawConfig {
  double false_alarms = 1e-6;
  std::uint64_t cases = 1;
  std::uint64_t max_draws = 4'000'000;
  std::uint64_t seed = 1;
};
void check_draws(const Judged& judged, const CutConfig& cut, const DrawConfig& config,
                 const PointCase& at, Tally& tally);

/// Scales, turns, shifts, reorders, splits and adds lights: all that is immaterial or scales
/// exactly, where the floats allow it.
void check_invariance(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally);

/// Shadow rays compared with brute force, and those of them too near an edge for rounding to
/// decide.
struct RayCount {
  std::uint64_t rays = 0, undecided = 0;
};

/// Casts a ray to a light that the point's surface faces: occlusion-equals-brute-force.
void check_ray(const Subject& subject, const SceneView& view, const VisiblePoint& from,
               std::uint32_t light, std::uint64_t place, RayCount& count, Tally& tally);

/// Renders the case's triangles, and casts rays from what is seen to all lights:
/// pixels-equal-points, occlusion-equals-brute-force, results-are-finite.
void check_picture(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally);

} // namespace lightcuts::oracle
