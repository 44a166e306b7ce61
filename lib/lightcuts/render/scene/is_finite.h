// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace lightcuts {

[[nodiscard]] inline bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace lightcuts
