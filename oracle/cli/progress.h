// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace lightcuts::cli {

/// A line on stderr with the share done and the time left; nothing unless stderr is a terminal.
class Progress {
public:
  explicit Progress(std::string task);
  ~Progress(); ///< clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share in [0, 1]; may be called from any thread.
  void update(double share);
  /// update() as a callable; empty where there is nothing to draw on. Must not outlive this.
  [[nodiscard]] std::function<void(double)> callback();

private:
  using Clock = std::chrono::steady_clock;

  std::string task_;
  bool visible_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
};

} // namespace lightcuts::cli
