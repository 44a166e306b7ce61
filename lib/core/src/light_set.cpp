// SPDX-License-Identifier: MIT
#include <lightcuts/light_set.h>

#include <cmath>
#include <string>

#include "number_text.h"
#include <lightcuts/input_error.h>

namespace lightcuts {

void LightSet::add_omni(const glm::vec3& position, const glm::vec3& intensity) {
  const auto refuse = [&](const char* field, int axis, const char* axes, float value,
                          const char* why) {
    throw InputError("light " + std::to_string(size()) + ": " + field + "." + axes[axis] + " is " +
                     number_text(value) + ", " + why);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(position[axis]))
      refuse("position", axis, "xyz", position[axis], "not a finite number");
    if (!std::isfinite(intensity[axis]))
      refuse("intensity", axis, "rgb", intensity[axis], "not a finite number");
    if (intensity[axis] < 0) refuse("intensity", axis, "rgb", intensity[axis], "negative");
  }
  lights_.push_back({position, intensity});
}

} // namespace lightcuts
