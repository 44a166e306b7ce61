// SPDX-License-Identifier: MIT
#include <lightcuts/core/shading/shading_frame.h>

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/exact_dot.h>

namespace lightcuts {
namespace {

double length(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }

void require_finite(const glm::vec3& v, const char* name) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(v[axis]))
      throw InputError(InputFault::not_finite, std::string("shading point: ") + name + "." +
                                                   "xyz"[axis] + " is not a finite number");
}

void require_unit(const glm::vec3& v, const char* name) {
  require_finite(v, name);
  const double l = length(v);
  if (!(std::abs(l - 1) <= 1e-5))
    throw InputError(InputFault::not_unit, std::string("shading point: ") + name + " has length " +
                                               std::to_string(l) + ", not 1");
}

glm::vec3 mirrored(const glm::dvec3& n, const glm::dvec3& o) {
  return glm::vec3(glm::normalize(2 * glm::dot(n, o) / glm::dot(n, n) * n - o));
}

} // namespace

ShadingFrame::ShadingFrame(const glm::vec3& position, const glm::vec3& normal,
                           const glm::vec3& to_viewer)
    : position_(position), normal_(normal), to_viewer_(to_viewer) {
  require_finite(position, "position");
  require_unit(normal, "normal");
  require_unit(to_viewer, "to_viewer");
  mirror_ = mirrored(normal, to_viewer);
  inverse_normal_length_ = 1 / length(normal_);
  inverse_viewer_length_ = 1 / length(to_viewer_);
  inverse_mirror_length_ = 1 / length(mirror_);
  viewer_cosine_ = dot_between(normal_, glm::vec3(0), to_viewer_) * inverse_normal_length_ *
                   inverse_viewer_length_;
}

} // namespace lightcuts
