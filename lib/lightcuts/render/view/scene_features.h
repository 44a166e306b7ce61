// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts {

/// What a scene needs of the algorithm, found once; what it does not need is left out.
struct SceneFeatures {
  LightKinds kinds = 0;   ///< of the lights
  bool clamp = false;     ///< distances are clamped; see LightSet::set_min_distance()
  bool specular = false;  ///< some surface has a glossy lobe
  bool occlusion = false; ///< something may come between a surface and a light: cast shadow rays
  bool tree = false;      ///< cuts are expected to cost less than all lights

  bool sees_surface = false; ///< some pixel of the pilot sees one

  // What `tree` was decided by: means over a grid of pixels that see a surface.
  double pilot_cut_size = 0;     ///< clusters per cut at the given threshold
  double pilot_cost_of_cuts = 0; ///< in units of the next one
  double pilot_cost_of_sums = 1; ///< of summing all lights

  /// Radiance under which a cluster's error cannot be seen: 2^-11 of the pilot's mean radiance,
  /// about half the smallest step of an 8-bit picture that shows the mean at 18 % grey.
  float black_level = 0;
};

/// The threshold that gives pictures with a mean error of 1 % or less, chosen from curves of error
/// against threshold over the `cloud` scenes: 1 % where something may occlude, since visibility
/// then makes the error; 0.5 % where all lights are oriented or spots besides. In the open
/// estimates are far better than their bounds: 2 % with oriented lights or spots, 16 % with glossy
/// surfaces, 50 % without either.
[[nodiscard]] float default_threshold(const SceneView& view);

/// Largest cut that goes with it: with the paper's 1000, hard scenes (spots that face all ways)
/// stop at an error of 7 % instead of finding that all lights cost less.
inline constexpr std::uint32_t default_max_cut = 5000;

/// Looks at the scene, and at cuts for about 200 pixels chosen by position. Decides by counting
/// (clusters, rays, lights), never by the clock: same inputs, same answer.
[[nodiscard]] SceneFeatures find_scene_features(const SceneView& view, const LightTree& tree,
                                                const CutConfig& config);

} // namespace lightcuts
