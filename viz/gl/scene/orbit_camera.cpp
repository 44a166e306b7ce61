// SPDX-License-Identifier: MIT
#include <viz/gl/scene/orbit_camera.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts::viz {
namespace {

/// The horizontal directions from which yaw 0 and yaw pi/2 look at the target.
struct Horizon {
  glm::dvec3 front{0}, side{0};
};

int axis_of(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  if (size.y >= size.x && size.y >= size.z) return 1;
  return size.z >= size.x ? 2 : 0;
}

Horizon horizon_of(const glm::dvec3& up) {
  const int axis = axis_of(up);
  Horizon horizon;
  horizon.front[(axis + 1) % 3] = 1;
  horizon.side[(axis + 2) % 3] = up[axis] < 0 ? -1 : 1;
  return horizon;
}

glm::dvec3 nearest_axis(const glm::dvec3& v) {
  const int axis = axis_of(v);
  glm::dvec3 result(0);
  result[axis] = v[axis] < 0 ? -1 : 1;
  return result;
}

/// Unit, from the target to the eye.
glm::dvec3 outwards(const OrbitCamera& camera) {
  const Horizon horizon = horizon_of(camera.up);
  return std::cos(camera.pitch) *
             (std::cos(camera.yaw) * horizon.front + std::sin(camera.yaw) * horizon.side) +
         std::sin(camera.pitch) * camera.up;
}

double limited_pitch(double pitch) {
  return std::clamp(pitch, -OrbitCamera::max_pitch, OrbitCamera::max_pitch);
}

double limited_distance(double distance) {
  return std::clamp(distance, OrbitCamera::min_distance, OrbitCamera::max_distance);
}

} // namespace

void OrbitCamera::orbit(double yaw_by, double pitch_by) {
  yaw = std::remainder(yaw + yaw_by, 2 * std::numbers::pi);
  pitch = limited_pitch(pitch + pitch_by);
}

void OrbitCamera::pan(const glm::dvec2& pixels, glm::uvec2 size) {
  const ViewFrame view = frame(size);
  const glm::dvec2 metres = 2 * distance * view.half * pixels / glm::dvec2(size);
  target += metres.y * view.up - metres.x * view.right;
}

void OrbitCamera::dolly(double factor) { distance = limited_distance(distance * factor); }

void OrbitCamera::fit(const Box& box, glm::uvec2 size) {
  if (box.lo.x > box.hi.x) return;
  const glm::dvec3 lo(box.lo), hi(box.hi);
  target = 0.5 * (lo + hi);
  const double radius = 0.5 * glm::length(hi - lo);
  const glm::dvec2 half = frame(size).half;
  const double narrow = std::atan(std::min(half.x, half.y)); // half the smaller field of view
  distance = radius > 0 ? limited_distance(radius / std::sin(narrow)) : 1;
}

glm::dvec3 OrbitCamera::eye() const { return target + distance * outwards(*this); }

Camera OrbitCamera::to_camera() const {
  return {glm::vec3(eye()), glm::vec3(target), glm::vec3(up), float(vertical_fov)};
}

ViewFrame OrbitCamera::frame(glm::uvec2 size) const {
  // Only directions and the lens are taken from the floats, and those are the same at the origin.
  const Camera turned{glm::vec3(outwards(*this)), glm::vec3(0), glm::vec3(up), float(vertical_fov)};
  ViewFrame view = view_frame(turned, size);
  view.forward = -outwards(*this);
  view.right = glm::normalize(glm::cross(view.forward, up));
  view.up = glm::cross(view.right, view.forward);
  view.origin = eye();
  return view;
}

std::optional<glm::dvec2> OrbitCamera::screen_position(const glm::dvec3& point,
                                                       glm::uvec2 size) const {
  return viz::screen_position(frame(size), size, point);
}

OrbitCamera OrbitCamera::from_camera(const Camera& camera, const glm::dvec3& pivot) {
  const glm::dvec3 eye(camera.position), ahead = glm::dvec3(camera.target) - eye;
  const glm::dvec3 forward = glm::normalize(ahead);
  const double depth = glm::dot(pivot - eye, forward);
  OrbitCamera result;
  result.vertical_fov = camera.vertical_fov;
  result.up = nearest_axis(camera.up);
  const Horizon horizon = horizon_of(result.up);
  result.yaw = std::atan2(-glm::dot(forward, horizon.side), -glm::dot(forward, horizon.front));
  result.pitch = limited_pitch(std::asin(std::clamp(-glm::dot(forward, result.up), -1.0, 1.0)));
  result.distance = limited_distance(depth > 0 ? depth : glm::length(ahead));
  result.target = eye - result.distance * outwards(result);
  return result;
}

} // namespace lightcuts::viz
