// SPDX-License-Identifier: MIT
#pragma once

#include <array>
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
[[nodiscard]] constexpr std::array<const char*, 2> names_of(TreeUse /*any*/) {
  return {"automatic", "always"};
}

/// How pixels are lit: everything that a slider changes without opening the scene again.
struct ShadingSettings {
  std::optional<float> threshold; ///< nothing: the scene's own, default_threshold()
  std::uint32_t max_cut = default_max_cut;
  ClusterRules rules; ///< of the method lightcuts
  TreeUse tree_use = TreeUse::automatic;
  std::uint64_t seed = 1; ///< of the methods that draw lights

  bool operator==(const ShadingSettings&) const = default;

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("threshold", &ShadingSettings::threshold, Domain{.least = 0, .optional = true});
    field("max_cut", &ShadingSettings::max_cut, Domain{.least = 1, .optional = true});
    field("rules", &ShadingSettings::rules, domain::inlined);
    field("tree_use", &ShadingSettings::tree_use, domain::optional);
    field("seed", &ShadingSettings::seed, domain::optional);
  }
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
