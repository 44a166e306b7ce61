// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/scene_view.h>

namespace lightcuts::oracle {

/// 64 random bits, the same for the same arguments (splitmix64 of both).
[[nodiscard]] inline std::uint64_t hashed(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed * 0xd1342543de82ef95U + (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// The index-th random point that the view sees: uniform over such pixels, with repetition. Throws
/// InputError where 10^5 pixels in a row see nothing.
[[nodiscard]] VisiblePoint random_point(const SceneView& view, std::uint64_t seed,
                                        std::uint64_t index);

} // namespace lightcuts::oracle
