// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace lightcuts::viz {

/// While it lives, the loss of the connection to the X server ends the process with code 3 and a
/// message on stderr, after `last_words`, which must not speak to the server. One at a time.
/// Nothing else can be done: Xlib does not return from the call that found it lost.
class LostDisplayGuard {
public:
  explicit LostDisplayGuard(std::function<void()> last_words);
  ~LostDisplayGuard();
  LostDisplayGuard(const LostDisplayGuard&) = delete;
  LostDisplayGuard& operator=(const LostDisplayGuard&) = delete;
};

} // namespace lightcuts::viz
