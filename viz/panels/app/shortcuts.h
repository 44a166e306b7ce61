// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <viz/model/workbench.h>

namespace lightcuts::viz {

/// A key, and what it does, for people.
struct Shortcut {
  const char* keys;
  const char* effect;
};

/// All there are, the mouse's too, in the order to show them.
[[nodiscard]] std::span<const Shortcut> all_shortcuts();

/// Requests of keys to the window itself in this frame; all others are acted upon at once.
struct KeyRequests {
  bool open = false, save = false, help = false, quit = false;
  bool flip = false; ///< the reference is to be shown while held
};

/// Acts on the keys of this frame, unless somebody types. Keys are GLFW's.
KeyRequests handle_keys(Workbench& workbench);

} // namespace lightcuts::viz
