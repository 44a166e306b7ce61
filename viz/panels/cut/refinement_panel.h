// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// "Why this cut?": a slider through the refinements, and how total, certified error and largest
/// bound went.
void draw_refinement_panel(Workbench& workbench);

} // namespace lightcuts::viz
