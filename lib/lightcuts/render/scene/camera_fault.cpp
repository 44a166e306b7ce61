// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/camera_fault.h>

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace lightcuts {
namespace {

bool all_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

std::optional<CameraFault> camera_fault(const Camera& camera) {
  using enum InputFault;
  if (!all_finite(camera.position)) return {{not_finite, "position is not finite"}};
  if (!all_finite(camera.target)) return {{not_finite, "target is not finite"}};
  if (!all_finite(camera.up)) return {{not_finite, "up is not finite"}};
  if (!(camera.vertical_fov > 0 && camera.vertical_fov < 180))
    return {{fault_of(camera.vertical_fov),
             fmt::format("fov is {}, expected more than 0 and less than 180 degrees",
                         camera.vertical_fov)}};
  if (camera.position == camera.target) return {{inconsistent, "position equals target"}};
  if (camera.up == glm::vec3(0)) return {{out_of_domain, "up is zero"}};
  const glm::dvec3 view = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
  // Below this sine the image's horizontal is lost in the rounding of floats.
  if (glm::length(glm::cross(view, glm::normalize(glm::dvec3(camera.up)))) < 1e-6)
    return {{inconsistent, "up is parallel to the view"}};
  return std::nullopt;
}

} // namespace lightcuts
