// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/render/scene/scene.h>

#include <viz/gl/scene/view_frame.h>

namespace lightcuts::viz {

/// A camera that looks at a point from somewhere on a sphere around it, as the mouse moves it.
struct OrbitCamera {
  static constexpr double max_pitch = 1.55; ///< radians: short of the poles, where `up` fails
  static constexpr double min_distance = 1e-6, max_distance = 1e15; ///< metres

  glm::dvec3 target{0};     ///< metres
  double distance = 1;      ///< from the target, metres, above 0
  double yaw = 0;           ///< radians around `up`; with up = +y, 0 is seen from +z, pi/2 from +x
  double pitch = 0;         ///< radians above the target, in [-max_pitch, max_pitch]
  double vertical_fov = 45; ///< degrees, in (0, 180)
  glm::dvec3 up{0, 1, 0};   ///< one of the axes, or its opposite

  /// Turns around the target, radians.
  void orbit(double yaw_by, double pitch_by);
  /// Shifts the camera so that the picture of the target moves by that many pixels (to the right,
  /// down) in an image of `size`.
  void pan(const glm::dvec2& pixels, glm::uvec2 size);
  /// Multiplies the distance; factor above 0.
  void dolly(double factor);
  /// Looks at the box's centre from where all of the box is seen in an image of `size`, without
  /// turning. An empty box changes nothing.
  void fit(const Box& box, glm::uvec2 size);

  /// Where the camera stands, metres.
  [[nodiscard]] glm::dvec3 eye() const;
  [[nodiscard]] Camera to_camera() const;
  /// The frame of to_camera() before rounding to floats; throws InputError as view_frame() does.
  [[nodiscard]] ViewFrame frame(glm::uvec2 size) const;
  /// Of a point (metres); see lightcuts::viz::screen_position.
  [[nodiscard]] std::optional<glm::dvec2> screen_position(const glm::dvec3& point,
                                                          glm::uvec2 size) const;

  /// Stands where `camera` stands and looks where it looks; turns around the point on the line of
  /// sight that is as deep as `pivot`, or around the camera's target where the pivot is behind.
  /// `up` becomes the axis nearest to the camera's, so that a rolled camera is put upright, and
  /// one that looks along it turns by up to a degree or two. The camera must be valid.
  [[nodiscard]] static OrbitCamera from_camera(const Camera& camera, const glm::dvec3& pivot);
};

} // namespace lightcuts::viz
