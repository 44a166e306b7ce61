// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>
#include <viz/panels/picture/image_panel.h>

namespace lightcuts::viz {

/// A line below the image: how far it has come, or how long it took, and statistics of the layer.
/// Only with a scene.
void draw_status(Workbench& workbench, const ImagePanel& image);

} // namespace lightcuts::viz
