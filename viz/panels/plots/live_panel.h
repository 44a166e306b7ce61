// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// Threshold, cut size, bound, estimate, clamp and seeds: what changes renders anew.
void draw_live_panel(Workbench& workbench);

} // namespace lightcuts::viz
