// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

namespace lightcuts {

/// Thrown by a job that has a result only as a whole, where it is cancelled.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Whom a long job tells how far it has come, and asks whether to leave the rest. By default nobody
/// listens, and the job goes on to its end.
class Progress {
public:
  Progress() = default;
  /// report: given the share done, in [0, 1]; cancelled: whether to leave the rest. Both by any of
  /// the job's threads, unless it says otherwise; either may be empty.
  explicit Progress(std::function<void(double)> report, std::function<bool()> cancelled = {})
      : report_(std::move(report)), cancelled_(std::move(cancelled)) {}
  /// Nobody is told; the job goes on until this is true.
  [[nodiscard]] static Progress until(std::function<bool()> cancelled) {
    return Progress({}, std::move(cancelled));
  }

  void report(double share) const {
    if (report_) report_(share);
  }
  [[nodiscard]] bool cancelled() const { return cancelled_ && cancelled_(); }
  /// Throws Cancelled.
  void leave_if_cancelled() const {
    if (cancelled()) throw Cancelled();
  }
  /// The progress of a part of the job: from the share `begin` of the whole, `length` of it. This
  /// must outlive the part's.
  [[nodiscard]] Progress part(double begin, double length) const {
    if (!report_) return *this;
    return Progress([this, begin, length](double share) { report_(begin + length * share); },
                    cancelled_);
  }

private:
  std::function<void(double)> report_;
  std::function<bool()> cancelled_;
};

} // namespace lightcuts
