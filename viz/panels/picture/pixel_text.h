// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <glm/vec2.hpp>

#include <viz/model/workbench.h>
#include <viz/panels/picture/shown_picture.h>

namespace lightcuts::viz {

/// All that is known of a pixel of the display: place, RGB, cut size, error, a line each.
[[nodiscard]] std::string pixel_text(Workbench& workbench, glm::uvec2 pixel);

/// Writes the value of pixel i into it; `at`: its middle on the screen, zoom: its side.
void draw_value_in_pixel(const ShownPicture& shown, std::size_t i, const glm::dvec2& at,
                         float zoom);

} // namespace lightcuts::viz
