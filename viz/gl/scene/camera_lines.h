// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/render/scene/scene.h>

#include <viz/model/cut/overlay.h>

namespace lightcuts::viz {

/// The pyramid from a camera's pinhole to the corners of its image, held `depth` metres in front
/// of it, with a tick on the upper edge. `size`: the image in pixels. Throws InputError as
/// PinholeView does.
[[nodiscard]] std::vector<ColouredLine> camera_lines(const Camera& camera, glm::uvec2 size,
                                                     double depth, const Rgba8& colour);

} // namespace lightcuts::viz
