// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <lightcuts/core/kernels/cluster_kernel.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/subjects/subject.h>

#include <viz/model/scene/opened_scene.h>

namespace lightcuts::viz {

/// How lightcuts decides whether a tree is worth its while.
enum class TreeUse : std::uint8_t {
  automatic, ///< sums all lights where cuts are expected to cost more; see SceneFeatures::tree
  always
};

/// How pixels are lit: everything that a slider changes without opening the scene again.
struct ShadingSettings {
  std::optional<float> threshold; ///< nothing: the scene's own, default_threshold()
  std::uint32_t max_cut = default_max_cut;
  ClusterRules rules; ///< of the method lightcuts
  TreeUse tree_use = TreeUse::automatic;
  std::uint64_t seed = 1; ///< of the methods that draw lights

  bool operator==(const ShadingSettings&) const = default;
};

/// With the scene's threshold and black level; unoccluded as the view says, of a counterexample
/// only if its own cut is.
[[nodiscard]] CutConfig cut_config(const ShadingSettings& settings, const OpenedScene& scene,
                                   const SceneView& view);

/// The rules by which the method picks cuts and estimates clusters: settings.rules for lightcuts,
/// and for the reference, which has no cut, the same.
[[nodiscard]] ClusterRules rules_of(Method method, const ShadingSettings& settings);

/// A tree that answers as the method does, for one thread: of a counterexample, its subject's.
[[nodiscard]] std::unique_ptr<oracle::SubjectTree>
tree_for(Method method, const ShadingSettings& settings, const OpenedScene& scene);

} // namespace lightcuts::viz
