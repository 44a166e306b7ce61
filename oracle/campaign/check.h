// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/jobs/progress.h>
#include <lightcuts/render/view/scene_view.h>
#include <oracle/properties/properties.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

struct CheckConfig {
  std::uint64_t seed = 1;      ///< of the choice of pixels and rays
  std::uint64_t tree_seed = 1; ///< of the subject's tree
  CutConfig cut;
  std::uint64_t pairs = 10'000'000; ///< (node, shading point) pairs to check at least
  double seconds = 0;               ///< ends after so many, with whole points; 0: no limit
  unsigned threads = 0;             ///< 0: one per core
  Progress progress;                ///< told and asked now and then, by one thread
  /// Given what has been counted so far, twice a minute, by one thread; may be empty.
  std::function<void(const struct CheckResult&)> checkpoint;
};

/// What check() has counted. Points are visited in order, so that it can go on from there.
struct CheckResult {
  Tally tally;
  std::uint64_t points = 0;         ///< shading points visited
  std::uint64_t pairs = 0;          ///< (node, shading point) pairs
  std::uint64_t rays = 0;           ///< shadow rays compared with brute force
  std::uint64_t undecided_rays = 0; ///< shadow rays too near an edge for rounding to decide
  double seconds = 0;               ///< wall time
  std::uint64_t swept_pairs = 0;    ///< pairs whose bounds alone were checked, many at a time
  double sweep_seconds = 0;         ///< time that swept_pairs took, summed over threads
  bool complete = true;             ///< false: out of time, cancelled, or the subject failed
};

/// Of so many shading points one has everything checked, the others bounds alone, where the lights
/// are omni and the surface is diffuse (elsewhere, all have): coverage is cheap there.
inline constexpr std::uint64_t points_per_full_check = 32;

/// One shading point in so many is not one that the camera sees, but beside a light: see
/// view_beside_light(). Clusters are judged there, and nothing else.
inline constexpr std::uint64_t points_per_beside_light = 8;
[[nodiscard]] constexpr bool is_beside_light(std::uint64_t place) {
  return place % points_per_beside_light == points_per_beside_light / 2;
}

/// One shading point in so many is bounded together with its neighbours, too, of subjects that
/// bound blocks: see block_at().
inline constexpr std::uint64_t points_per_block = 32;
[[nodiscard]] constexpr bool is_of_block(std::uint64_t place) {
  return place % points_per_block == 1;
}

/// Judges the subject on the scene: every property of the tree and of the materials; every cluster
/// and several cuts at shading points chosen at random among the pixels that see a surface, and
/// beside lights; clusters from blocks of neighbouring pixels; shadow rays from there; and excerpts
/// of few lights. Goes on from `done`, an earlier result of the same scene, subject and
/// configuration but for `pairs` and `seconds`. Same inputs, same counts, for any number of
/// threads, and however often it was interrupted. Throws InputError if the camera sees nothing.
[[nodiscard]] CheckResult check(const SceneView& view, const Subject& subject,
                                const CheckConfig& config, const CheckResult& done = {});

} // namespace lightcuts::oracle
