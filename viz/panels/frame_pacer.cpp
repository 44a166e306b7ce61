// SPDX-License-Identifier: MIT
#include "frame_pacer.h"

#include <algorithm>

namespace lightcuts::viz {

double FramePacer::patience(bool is_busy, Clock::time_point now) const {
  const double since = std::chrono::duration<double>(now - last_).count();
  const double wanted = eager_ > 0 ? fastest : is_busy ? busy : idle;
  return std::max(0.0, wanted - since);
}

void FramePacer::waited(double patience, double seconds) {
  const bool events = seconds < 0.9 * patience;
  if (events)
    eager_ = frames_after_event;
  else if (eager_ > 0)
    --eager_;
}

} // namespace lightcuts::viz
