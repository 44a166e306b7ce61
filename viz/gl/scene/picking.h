// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/geometry/box.h>
#include <lightcuts/core/lights/light_set.h>

#include <viz/gl/scene/view_frame.h>

namespace lightcuts::viz {

/// The index of the point (metres) whose picture is nearest to `mouse`, among those within `radius`
/// pixels of it; of equally near ones the one nearest to the camera. `mouse` as screen_position
/// counts. Goes through all points.
[[nodiscard]] std::optional<std::size_t> pick_point(const ViewFrame& frame, glm::uvec2 size,
                                                    std::span<const glm::dvec3> points,
                                                    const glm::dvec2& mouse, double radius);

/// Where the 3D view shows a light, metres: its position; a directional one where its light comes
/// from, as far from the centre of the scene's bounds as their diagonal is long, or 1 m from the
/// origin in a scene without extent.
[[nodiscard]] glm::dvec3 shown_position(const Light& light, const Box& scene);

} // namespace lightcuts::viz
