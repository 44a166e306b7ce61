// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts::viz {

/// A pinhole camera as a rasteriser wants it. Equal to PinholeView: a point at `origin` + d lies on
/// the image at (d.right, d.up) / (d.forward half), from -1 to 1, which the centres of the image's
/// border pixels miss by half a pixel.
struct ViewFrame {
  glm::dvec3 origin;             ///< metres
  glm::dvec3 right, up, forward; ///< unit, orthogonal
  glm::dvec2 half;               ///< half the width and height of the image at distance 1
};

/// For an image of `size` pixels. Throws InputError as PinholeView does.
[[nodiscard]] ViewFrame view_frame(const Camera& camera, glm::uvec2 size);

/// From offsets (position - origin, metres) to clip space, with nothing cut off in the distance.
/// Everything nearer than `near` metres in depth is cut off. The clip space's w is the depth along
/// `forward`; its z is good for clipping only: shaders set gl_FragDepth from w.
[[nodiscard]] glm::mat4 clip_from_offset(const ViewFrame& frame, double near);

/// Where a point (metres) is seen in an image of `size` pixels: pixels from its top left corner, so
/// that the first pixel's centre is (0.5, 0.5). Nothing for points that are not in front of the
/// camera; the place may lie outside the image.
[[nodiscard]] std::optional<glm::dvec2> screen_position(const ViewFrame& frame, glm::uvec2 size,
                                                        const glm::dvec3& point);

/// An upper bound of the distance from `from` to any point of the box, metres, above 0; 1 where
/// the box is empty.
[[nodiscard]] double reach(const glm::dvec3& from, const Box& box);

} // namespace lightcuts::viz
