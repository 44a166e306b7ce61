// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/io/json/json_element.h>
#include <lightcuts/render/lighting/shapes/shape_lights.h>

namespace lightcuts {

/// The shape that an element of "lights" with this "generate" describes; see load_scene_json().
/// Throws JsonError, naming what is wrong.
[[nodiscard]] ShapeLights read_shape(const JsonElement& element, ShapeKind kind);

} // namespace lightcuts
