// SPDX-License-Identifier: MIT
#include <oracle/cli/progress.h>

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace lightcuts::cli {

Progress::Progress(std::string task)
    : task_(std::move(task)), visible_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::update(double share) {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (now - drawn_ < std::chrono::milliseconds(100)) return;
  drawn_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const int width = 30;
  const int filled = static_cast<int>(share * width);
  const std::string left = share > 0.01
                               ? fmt::format("{:.0f} s left", elapsed * (1 - share) / share)
                               : std::string("...");
  fmt::print(stderr, "\r{} [{:#<{}}{: <{}}] {:3.0f} %  {}\x1b[K", task_, "", filled, "",
             width - filled, 100 * share, left);
  std::fflush(stderr);
}

std::function<void(double)> Progress::callback() {
  if (!visible_) return {};
  return [this](double share) { update(share); };
}

} // namespace lightcuts::cli
