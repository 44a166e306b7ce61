// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// A counterexample of the oracle: the property, bound and truth of the cluster that
/// breaks it side by side, and the oracle's arithmetic step by step. Needs a scene with a
/// counterexample.
void draw_counterexample_panel(Workbench& workbench);

} // namespace lightcuts::viz
