// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

namespace lightcuts::oracle {

/// Goes on to more lights only as long as a subject that takes N^3 would answer in time, going by
/// the most lights so far: a right tree that is slow is not to be taken for one that hangs.
class Ladder {
public:
  static constexpr double longest = 10; ///< seconds

  [[nodiscard]] bool dares(std::size_t lights) const {
    if (lights_ == 0) return true;
    const double times = double(lights) / double(lights_);
    return seconds_ * std::max(1.0, times * times * times) <= longest;
  }
  /// So many lights took so many seconds.
  void went(std::size_t lights, double seconds) {
    if (lights < lights_) return;
    lights_ = lights;
    seconds_ = seconds;
  }

private:
  std::size_t lights_ = 0;
  double seconds_ = 0;
};

} // namespace lightcuts::oracle
