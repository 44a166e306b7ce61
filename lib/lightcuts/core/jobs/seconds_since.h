// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace lightcuts {

/// The clock by which jobs are timed: it is never set back.
using Clock = std::chrono::steady_clock;

/// Wall time since then.
[[nodiscard]] inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace lightcuts
