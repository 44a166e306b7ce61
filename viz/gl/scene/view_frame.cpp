// SPDX-License-Identifier: MIT
#include <viz/gl/scene/view_frame.h>

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lightcuts/render/view/camera.h>

namespace lightcuts::viz {

ViewFrame view_frame(const Camera& camera, glm::uvec2 size) {
  [[maybe_unused]] const PinholeView check(camera, size); // throws
  const glm::dvec3 origin(camera.position);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target) - origin);
  const glm::dvec3 right =
      glm::normalize(glm::cross(forward, glm::normalize(glm::dvec3(camera.up))));
  const double half_height = std::tan(camera.vertical_fov * (std::numbers::pi / 360));
  return {origin, right, glm::cross(right, forward), forward,
          half_height * glm::dvec2(double(size.x) / size.y, 1)};
}

glm::mat4 clip_from_offset(const ViewFrame& frame, double near) {
  const glm::dvec3 x = frame.right / frame.half.x, y = frame.up / frame.half.y;
  const glm::dvec3& w = frame.forward;
  // z = w - 2 near lies in [-w, w] exactly from w = near on.
  return {glm::vec4(x.x, y.x, w.x, w.x), glm::vec4(x.y, y.y, w.y, w.y),
          glm::vec4(x.z, y.z, w.z, w.z), glm::vec4(0, 0, -2 * near, 0)};
}

std::optional<glm::dvec2> screen_position(const ViewFrame& frame, glm::uvec2 size,
                                          const glm::dvec3& point) {
  const glm::dvec3 d = point - frame.origin;
  const double depth = glm::dot(d, frame.forward);
  if (!(depth > 0)) return std::nullopt;
  const glm::dvec2 place(glm::dot(d, frame.right), -glm::dot(d, frame.up));
  return 0.5 * (1.0 + place / (depth * frame.half)) * glm::dvec2(size);
}

double reach(const glm::dvec3& from, const Box& box) {
  if (box.lo.x > box.hi.x) return 1;
  const glm::dvec3 far =
      glm::max(glm::abs(glm::dvec3(box.lo) - from), glm::abs(glm::dvec3(box.hi) - from));
  const double distance = glm::length(far);
  return distance > 0 ? distance : 1;
}

} // namespace lightcuts::viz
