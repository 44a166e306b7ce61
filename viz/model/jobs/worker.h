// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <lightcuts/core/jobs/progress.h>

namespace lightcuts::viz {

/// How much a worker's thread, and what it starts, gives way to the window.
enum class Niceness { prompt, background };

/// One thread that does one job at a time, of which only the latest matters: a new one cancels the
/// one before, and takes the place of one that waits.
class Worker {
public:
  /// A job that can be left asks now and then, and returns soon after it is cancelled; one that
  /// cannot is waited for.
  using Job = std::function<void(const Progress&)>;

  explicit Worker(Niceness niceness);
  /// Cancels, and waits for the job to return.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Does not wait.
  void start(Job job);
  void cancel();
  /// Whether a job runs or waits.
  [[nodiscard]] bool busy() const;
  /// The share done, in [0, 1], of the job that runs, or ran last, as far as it has told.
  [[nodiscard]] double share() const { return share_; }

private:
  void run(const std::stop_token& end);

  Niceness niceness_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> next_;
  std::stop_source current_;
  bool running_ = false;
  std::atomic<double> share_ = 0;
  std::jthread thread_; ///< last: starts when the rest is there
};

} // namespace lightcuts::viz
