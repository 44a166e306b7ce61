// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace lightcuts {

/// Step from one state of the generator SplitMix64 (Steele, Lea & Flood 2014) to the next.
inline constexpr std::uint64_t splitmix64_step = 0x9e3779b97f4a7c15U;

/// The number that SplitMix64 gives in a state: 64 random bits, the same everywhere.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t state) {
  std::uint64_t z = state + splitmix64_step;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

} // namespace lightcuts
