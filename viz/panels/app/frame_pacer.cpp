// SPDX-License-Identifier: MIT
#include <viz/panels/app/frame_pacer.h>

#include <algorithm>

namespace lightcuts::viz {

double FramePacer::patience(bool is_busy, Clock::time_point now) const {
  const auto since = [now](Clock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  const double left = eager_ > 0 ? fastest - since(start_) : (is_busy ? busy : idle) - since(end_);
  return std::max(0.0, left);
}

void FramePacer::waited(double patience, double seconds) {
  const bool events = seconds < 0.9 * patience;
  if (events)
    eager_ = frames_after_event;
  else if (eager_ > 0)
    --eager_;
}

} // namespace lightcuts::viz
