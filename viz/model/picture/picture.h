// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/render/view/renderer.h>

namespace lightcuts::viz {

/// A picture that one thread at a time makes, coarse first, and others look at meanwhile. What is
/// known of it is known per pixel; what is not is shown by the nearest known pixel to the upper
/// left of a coarser grid.
class Picture {
public:
  /// Pixels whose coordinates are multiples of these, one pass after the other.
  static constexpr std::array<unsigned, 3> steps{16, 4, 1};

  /// Begins with the first of the steps, or, where what is coarse takes as long as all, the last.
  explicit Picture(glm::uvec2 size, bool coarse_first = true);
  virtual ~Picture() = default;
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Goes on until complete or cancelled; what was done stays. Tells nothing: see share(). Failing,
  /// it keeps the message as failure().
  void advance(const Progress& progress = {});

  [[nodiscard]] glm::uvec2 size() const { return size_; }
  [[nodiscard]] std::size_t pixel_count() const { return std::size_t(size_.x) * size_.y; }
  /// Of the pixels, 0 to 1.
  [[nodiscard]] double share() const;
  [[nodiscard]] bool complete() const;
  /// Grows with whatever becomes known.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Spent so far, wall time; grows while it is being made.
  [[nodiscard]] double seconds() const;
  /// Until it is complete, as it went so far; nothing before there is anything to go by.
  [[nodiscard]] std::optional<double> seconds_left() const;
  /// Why it ended, or nothing.
  [[nodiscard]] std::string failure() const;

  /// Per pixel the pixel that stands for it, itself if known, or `unknown`. Of these nothing is
  /// written any more.
  static constexpr std::uint32_t unknown = ~0U;
  [[nodiscard]] std::vector<std::uint32_t> sources() const;
  /// The pixel that stands for this one, which is within the picture, or `unknown`; see sources().
  [[nodiscard]] std::uint32_t source_of(glm::uvec2 pixel) const;

protected:
  /// Makes the pixels for which wanted() holds, and says done() of each row of them.
  virtual void make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) = 0;
  /// The wanted ones among them become known. By any thread.
  void done(const PixelRect& rect);

private:
  void run_clock(bool on);
  [[nodiscard]] double spent() const;
  [[nodiscard]] std::uint32_t nearest_known(const std::vector<char>& known, glm::uvec2 pixel) const;
  [[nodiscard]] bool on_grid(glm::uvec2 pixel) const {
    return pixel.x % step_ == 0 && pixel.y % step_ == 0;
  }

  glm::uvec2 size_;
  bool coarse_first_;
  mutable std::mutex mutex_;
  std::vector<char> known_;
  std::size_t known_count_ = 0;
  double seconds_ = 0;                       ///< until the clock began to run
  std::optional<Clock::time_point> running_; ///< since then; nothing: it stands
  std::string failure_;
  std::atomic<std::uint64_t> version_ = 0;
  unsigned step_ = 1; ///< of the pass; only changes between passes
};

} // namespace lightcuts::viz
