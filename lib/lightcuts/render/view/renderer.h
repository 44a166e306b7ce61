// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/jobs/progress.h>
#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts {

/// A rectangle of pixels: x in [lo.x, hi.x), y in [lo.y, hi.y).
struct PixelRect {
  glm::uvec2 lo{0}, hi{0};
};

struct RenderConfig {
  Method method = methods::lightcuts;
  CutConfig cut;          ///< for all methods but the reference
  bool use_tree = true;   ///< false: lightcuts sums all lights, see SceneFeatures::tree
  bool specialise = true; ///< false: cuts by the kernel for any scene, which casts
                          ///< every shadow ray; to compare with
  unsigned threads = 0;   ///< 0: one per core; default 0
  std::uint64_t seed = 1; ///< of the methods that draw lights; default 1
  /// In place of those of lightcuts, by the kernel for any scene; default: none
  std::optional<ClusterRules> rules;
  Progress progress; ///< asked before each pixel whether to leave the others
  /// Called when wanted pixels of a rectangle have been written, by the thread that did; nobody
  /// writes to them any more. May be empty.
  std::function<void(const PixelRect&)> done;
};

/// One picture, row by row from the top left. Where a pixel sees no surface all is 0 but emission.
struct Rendering {
  glm::uvec2 size{0};
  std::vector<glm::vec3> radiance;        ///< reflected towards the camera; emission is not in it
  std::vector<glm::vec3> certified_error; ///< |radiance - exact| is at most this
  std::vector<glm::vec3> emission; ///< of the surface itself; where none is seen, from beyond all
  std::vector<float> cut_size;     ///< clusters, or lights (reference)
  std::vector<float> shadow_rays;
  std::vector<float> microseconds; ///< wall time of the pixel
  std::vector<CutEnd> end;
  std::uint64_t surface_pixels = 0; ///< pixels that see a surface
  double seconds = 0;               ///< wall time of the whole, primary rays included
};

/// A picture of which nothing is rendered yet.
[[nodiscard]] Rendering blank_rendering(glm::uvec2 size);

/// Renders in tiles over the threads. All but the times are the same bits for any number of
/// threads.
[[nodiscard]] Rendering render(const SceneView& view, const LightTree& tree,
                               const RenderConfig& config);

/// Renders those pixels that are wanted into a picture of the view's size; the others stay as they
/// are. surface_pixels and seconds are added to what they were. wanted() is asked by any
/// thread, once per pixel.
void render_into(Rendering& picture, const SceneView& view, const LightTree& tree,
                 const RenderConfig& config, const std::function<bool(glm::uvec2)>& wanted);

} // namespace lightcuts
