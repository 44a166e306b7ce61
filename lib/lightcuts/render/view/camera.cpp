// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/camera.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>

namespace lightcuts {
namespace {

void require_finite(const glm::vec3& v, const char* field) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
    throw InputError(InputFault::not_finite, std::string("camera: ") + field + " is not finite");
}

void validate(const Camera& camera, glm::uvec2 size) {
  require_finite(camera.position, "position");
  require_finite(camera.target, "target");
  require_finite(camera.up, "up");
  if (!(camera.vertical_fov > 0 && camera.vertical_fov < 180))
    throw InputError(fault_of(camera.vertical_fov),
                     "camera: vertical_fov lies outside (0, 180) degrees");
  if (size.x == 0 || size.y == 0)
    throw InputError(InputFault::out_of_domain, "camera: the image has no pixels");
}

// Squares of floats neither over- nor underflow in double, so only a true zero has length 0.
glm::dvec3 unit(const glm::dvec3& v, InputFault fault, const char* message) {
  const double length = glm::length(v);
  if (length == 0) throw InputError(fault, message);
  return v / length;
}

} // namespace

PinholeView::PinholeView(const Camera& camera, glm::uvec2 size) : origin_(camera.position) {
  validate(camera, size);
  const glm::dvec3 forward = unit(glm::dvec3(camera.target) - glm::dvec3(camera.position),
                                  InputFault::inconsistent, "camera: position and target coincide");
  const glm::dvec3 up =
      unit(glm::dvec3(camera.up), InputFault::out_of_domain, "camera: up is zero");
  const glm::dvec3 side = glm::cross(forward, up);
  // forward and up carry a few roundings of 2^-53: a sine below 2^-48 is not told from 0.
  if (glm::length(side) < 0x1p-48)
    throw InputError(InputFault::inconsistent, "camera: up is parallel to the view");
  const glm::dvec3 right = glm::normalize(side);
  const glm::dvec3 down = glm::cross(forward, right);

  const double half_height = std::tan(camera.vertical_fov * (std::numbers::pi / 360));
  const double pixel = 2 * half_height / size.y;
  step_x_ = pixel * right;
  step_y_ = pixel * down;
  corner_ = forward - 0.5 * size.x * step_x_ - 0.5 * size.y * step_y_;
}

glm::vec3 PinholeView::direction(glm::uvec2 pixel) const {
  return glm::vec3(glm::normalize(corner_ + (pixel.x + 0.5) * step_x_ + (pixel.y + 0.5) * step_y_));
}

} // namespace lightcuts
