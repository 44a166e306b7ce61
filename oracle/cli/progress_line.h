// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <mutex>
#include <string>

#include <lightcuts/core/jobs/progress.h>
#include <lightcuts/core/jobs/seconds_since.h>

namespace lightcuts::cli {

/// A line on stderr with the share done and the time left; nothing unless stderr is a terminal.
class ProgressLine {
public:
  explicit ProgressLine(std::string task);
  ~ProgressLine(); ///< clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// share in [0, 1]; may be called from any thread.
  void update(double share);
  /// For a job, which is asked to end once `cancelled` says so. Must not outlive this.
  [[nodiscard]] Progress progress(std::function<bool()> cancelled = {});

private:
  std::string task_;
  bool visible_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

} // namespace lightcuts::cli
