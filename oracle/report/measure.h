// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/renderer.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/report/report.h>

namespace lightcuts::oracle {

struct MeasureConfig {
  std::uint64_t seed = 1;
  Builder builder = Builder::greedy; ///< of the light tree
  std::vector<Method> methods{methods::reference, methods::lightcuts};
  std::vector<float> thresholds{0.01F, 0.02F, 0.04F, 0.08F}; ///< of the methods that have one
  std::uint32_t max_cut = default_max_cut;
  unsigned threads = 0; ///< 0: one per core
  int repeats = 3;      ///< runs of each row, in turn; the median counts
  Progress progress;
};

/// A report with the pictures that belong to it.
struct Measurement {
  Report report;
  SceneFeatures features; ///< at the threshold nearest to the scene's own, see default_threshold()
  Rendering reference;    ///< exact but for rounding
  Rendering shown;        ///< lightcuts at that threshold; the reference where it is not measured
  float shown_threshold = 0;
};

/// Renders every method at every threshold, several times in turn so that the machine's mood hits
/// all alike, and compares with the exact picture. Where lightcuts leaves the tree out it does what
/// the reference does, and has its times and picture. Throws InputError where the scene has no
/// light or the camera sees nothing, and Cancelled.
[[nodiscard]] Measurement measure(const SceneView& view, const MeasureConfig& config);

/// What leaving out what the scene does not need saves.
struct KernelSaving {
  double general_seconds = 0; ///< cuts by the kernel for any scene, see RenderConfig::specialise
  double specialised_seconds = 0; ///< what lightcuts does on this scene
};

/// Renders a small picture of the scene both ways, in turn, five times on one thread; medians.
[[nodiscard]] KernelSaving measure_kernels(const Scene& scene, const LightTree& tree,
                                           const SceneFeatures& features, const CutConfig& config);

/// What a scene needs of the algorithm, in words, and what is left out.
void describe_features(const SceneView& view, const SceneFeatures& features, float threshold,
                       std::vector<std::string>& needed, std::vector<std::string>& left_out);

} // namespace lightcuts::oracle
