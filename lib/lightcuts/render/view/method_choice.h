// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <lightcuts/core/methods/method.h>
#include <lightcuts/render/view/scene_features.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts {

/// The method that is expected to light a scene soonest, if that is by much where the other is
/// exact, and what that was decided by: means over pixels of a pilot, costs in units of summing all
/// lights.
struct MethodChoice {
  Method method;         ///< block_cuts, or lightcuts (which sums all lights where no tree pays)
  float threshold;       ///< to go with it
  double block_clusters; ///< of cuts that neighbours share, by their own threshold
  double block_rays;     ///< shadow rays a pixel
  double cost_of_blocks, cost_of_cuts;
};

/// The threshold of block_cuts that gives a mean error of 1 % or less, from curves of error against
/// threshold over the `cloud` scenes, `desk` and `bedroom`: among occluders 4 %, or 1 % where all
/// lights are oriented or spots; in the open as default_threshold().
[[nodiscard]] float default_block_threshold(const SceneView& view);

/// Lights some squares of pixels, spread evenly, by blocks, and compares what was counted with what
/// `features` says of cuts and sums, by the same costs. threshold: for either method; nothing: each
/// has its default. Same inputs, same answer. config: black level and largest cut; features: of the
/// same view and tree.
[[nodiscard]] MethodChoice choose_method(const SceneView& view, const LightTree& tree,
                                         const SceneFeatures& features,
                                         std::optional<float> threshold, CutConfig config);

} // namespace lightcuts
