// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts {

/// Random numbers that are the same bits everywhere, which the standard's distributions are not.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// The generator of element `index` of a sequence: elements can be made in any order.
  Random(std::uint64_t seed, std::uint64_t index)
      : state_(Random(seed).next() ^ Random(~index).next()) {}

  std::uint64_t next() {
    const std::uint64_t bits = splitmix64(state_);
    state_ += splitmix64_step;
    return bits;
  }

  /// In [0, 1), a multiple of 2^-24.
  float unit() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

  /// In [0, 1), a multiple of 2^-53.
  double unit_double() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// In [lo, hi]; `lo <= hi`, finite. In double, so that hi - lo cannot overflow.
  float between(float lo, float hi) {
    return static_cast<float>(lo + (static_cast<double>(hi) - lo) * static_cast<double>(unit()));
  }

private:
  std::uint64_t state_;
};

} // namespace lightcuts
