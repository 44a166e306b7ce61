// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/jobs/seconds_since.h>

namespace lightcuts::viz {

/// When to draw the next frame: at once while somebody does something, now and then while a picture
/// grows, so that what draws (software, maybe) leaves the processor to what renders, and twice a
/// second where nothing changes.
class FramePacer {
public:
  static constexpr double fastest =
      1.0 / 75;                       ///< seconds at least from one frame's start to the next
  static constexpr double busy = 0.1; ///< of rest, while something runs in the background
  static constexpr double idle = 0.5;

  /// For how many seconds to wait for events before the next frame.
  [[nodiscard]] double patience(bool is_busy, Clock::time_point now) const;
  /// To be told of every waiting: how long it was to last, and lasted, seconds; shorter: an event
  /// came.
  void waited(double patience, double seconds);
  void drawn(Clock::time_point start, Clock::time_point end) {
    start_ = start;
    end_ = end;
  }

private:
  static constexpr int frames_after_event = 3; ///< some things of ImGui take two

  Clock::time_point start_{}, end_{}; ///< of the last frame
  int eager_ = frames_after_event;
};

} // namespace lightcuts::viz
