// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/blocks/neighbours.h>
#include <lightcuts/core/methods/method.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts {

/// Pixels that are lit together by methods which share between neighbours: those of one square of a
/// fixed grid that see a surface, whichever of them are asked for.
struct PixelSquare {
  static constexpr unsigned side = 8;

  std::vector<glm::uvec2> pixels; ///< row by row
  std::vector<VisiblePoint> seen; ///< one for each of them
  std::vector<BlockPoint> points; ///< the same points
  std::uint64_t query = 0;        ///< the first pixel's index in the picture

  /// The square that has the pixel.
  PixelSquare(const SceneView& view, glm::uvec2 pixel);
  /// Where the shadow rays of the points start.
  [[nodiscard]] std::vector<glm::vec3> ray_origins() const;
};

/// Lights a square by a method that shares between neighbours, by rays and by what shafts prove. A
/// result for each of its pixels.
[[nodiscard]] std::vector<PixelResult> light(const PixelSquare& square, const SceneView& view,
                                             PointLighter& lighter);

} // namespace lightcuts
