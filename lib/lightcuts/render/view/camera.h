// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// The rays of a pinhole camera: one through the centre of each pixel, pixel (0,0) top left.
class PinholeView {
public:
  /// size: the image in pixels, each >= 1. Throws InputError where a field of the camera is not
  /// finite, the field of view lies outside (0, 180), position and target coincide, `up` is zero or
  /// parallel to the view, or size has a zero.
  PinholeView(const Camera& camera, glm::uvec2 size);

  /// Unit vector (to float rounding) from origin() through the centre of `pixel`; pixels beyond
  /// the image continue its grid.
  [[nodiscard]] glm::vec3 direction(glm::uvec2 pixel) const;

  /// The pinhole, metres.
  [[nodiscard]] const glm::vec3& origin() const { return origin_; }

private:
  glm::vec3 origin_;
  glm::dvec3 corner_;          // towards the image's top left corner, on the plane at distance 1
  glm::dvec3 step_x_, step_y_; // one pixel to the right, one pixel down, on that plane
};

} // namespace lightcuts
