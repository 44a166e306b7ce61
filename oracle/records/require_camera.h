// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <lightcuts/render/io/json/json_element.h>
#include <lightcuts/render/view/camera.h>

namespace lightcuts::oracle {

/// Refuses a camera that PinholeView does, which no domain of a single field says.
inline void require_camera(const JsonElement& element, const Camera& camera) {
  try {
    (void)PinholeView(camera, glm::uvec2(1));
  } catch (const InputError& error) {
    element.refuse_as(error.fault(), std::string(": ") + error.what());
  }
}

} // namespace lightcuts::oracle
