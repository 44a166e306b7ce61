// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/state/view_state.h>

namespace lightcuts::viz {

/// A row of choices of what the image shows: method, layer, split and, of heat maps, colours.
void draw_toolbar(ViewState& state);

} // namespace lightcuts::viz
