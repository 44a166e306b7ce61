// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// The selected pixel in a few lines: what it sees, its radiance beside the truth, its cut; and the
/// selected cluster.
void draw_pixel_panel(Workbench& workbench);

} // namespace lightcuts::viz
