// SPDX-License-Identifier: MIT
#include <oracle/cli/progress_line.h>

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace lightcuts::cli {

ProgressLine::ProgressLine(std::string task)
    : task_(std::move(task)), visible_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (visible_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressLine::update(double share) {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  if (seconds_since(drawn_) < 0.1) return;
  drawn_ = Clock::now();
  const int width = 30;
  const int filled = static_cast<int>(share * width);
  const std::string left =
      share > 0.01 ? fmt::format("{:.0f} s left", seconds_since(start_) * (1 - share) / share)
                   : std::string("...");
  fmt::print(stderr, "\r{} [{:#<{}}{: <{}}] {:3.0f} %  {}\x1b[K", task_, "", filled, "",
             width - filled, 100 * share, left);
  std::fflush(stderr);
}

Progress ProgressLine::progress(std::function<bool()> cancelled) {
  return Progress([this](double share) { update(share); }, std::move(cancelled));
}

} // namespace lightcuts::cli
