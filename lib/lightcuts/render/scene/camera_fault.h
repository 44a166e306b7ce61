// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// What is wrong with a camera; `what` begins with the field's name.
struct CameraFault {
  InputFault cause;
  std::string what;
};

/// The first fault of the camera, if it has any.
std::optional<CameraFault> camera_fault(const Camera& camera);

} // namespace lightcuts
