// SPDX-License-Identifier: MIT
#include <viz/model/picture/picture.h>

#include <exception>

namespace lightcuts::viz {

Picture::Picture(glm::uvec2 size, bool coarse_first)
    : size_(size), coarse_first_(coarse_first), known_(pixel_count(), 0) {}

void Picture::advance(const Progress& progress) {
  const Progress asked = Progress::until([&progress] { return progress.cancelled(); });
  run_clock(true);
  try {
    for (const unsigned step : steps) {
      if (asked.cancelled()) break;
      if (!coarse_first_ && step != steps.back()) continue;
      step_ = step;
      // A pixel becomes known by the thread that asked for it, so what it reads here is settled.
      make(
          [this](glm::uvec2 p) {
            return on_grid(p) && known_[std::size_t(p.y) * size_.x + p.x] == 0;
          },
          asked);
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    failure_ = error.what();
    ++version_;
  }
  run_clock(false);
}

void Picture::run_clock(bool on) {
  const std::lock_guard lock(mutex_);
  seconds_ = spent();
  running_ = on ? std::optional(Clock::now()) : std::nullopt;
}

double Picture::spent() const { return seconds_ + (running_ ? seconds_since(*running_) : 0); }

void Picture::done(const PixelRect& rect) {
  const std::lock_guard lock(mutex_);
  for (unsigned y = rect.lo.y; y < rect.hi.y; ++y)
    for (unsigned x = rect.lo.x; x < rect.hi.x; ++x) {
      if (!on_grid({x, y})) continue;
      char& known = known_[std::size_t(y) * size_.x + x];
      known_count_ += known == 0 ? 1 : 0;
      known = 1;
    }
  ++version_;
}

double Picture::share() const {
  const std::lock_guard lock(mutex_);
  return pixel_count() == 0 ? 1 : double(known_count_) / double(pixel_count());
}

bool Picture::complete() const {
  const std::lock_guard lock(mutex_);
  return known_count_ == pixel_count() || !failure_.empty();
}

double Picture::seconds() const {
  const std::lock_guard lock(mutex_);
  return spent();
}

std::optional<double> Picture::seconds_left() const {
  const double done = share();
  if (done <= 0) return std::nullopt;
  return seconds() * (1 - done) / done;
}

std::string Picture::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

std::uint32_t Picture::nearest_known(const std::vector<char>& known, glm::uvec2 pixel) const {
  for (std::size_t k = steps.size(); k-- > 0;) {
    const glm::uvec2 from = pixel - pixel % steps[k];
    const std::uint32_t i = from.y * size_.x + from.x;
    if (known[i] != 0) return i;
  }
  return unknown;
}

std::uint32_t Picture::source_of(glm::uvec2 pixel) const {
  const std::lock_guard lock(mutex_);
  return nearest_known(known_, pixel);
}

std::vector<std::uint32_t> Picture::sources() const {
  std::vector<char> known;
  {
    const std::lock_guard lock(mutex_); // briefly: who makes the picture waits for it
    known = known_;
  }
  std::vector<std::uint32_t> sources(pixel_count());
  for (unsigned y = 0; y < size_.y; ++y)
    for (unsigned x = 0; x < size_.x; ++x)
      sources[std::size_t(y) * size_.x + x] = nearest_known(known, {x, y});
  return sources;
}

} // namespace lightcuts::viz
