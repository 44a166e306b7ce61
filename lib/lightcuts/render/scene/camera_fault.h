// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// What is wrong with a camera, beginning with the field's name; empty if nothing is.
std::string camera_fault(const Camera& camera);

} // namespace lightcuts
