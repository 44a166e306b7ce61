// SPDX-License-Identifier: MIT
#pragma once

#include <viz/model/workbench.h>

/// Windows over everything else.
namespace lightcuts::viz {

/// The latest messages, if there are any, until a click on OK.
void draw_messages(Workbench& workbench);

/// All shortcuts, while `shown`; closing it clears that.
void draw_help(bool& shown);

} // namespace lightcuts::viz
