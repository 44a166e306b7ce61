// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lightcuts::viz {

/// How it was found whether a pixel sees a cluster of its cut.
enum class Sight : std::uint8_t {
  seen,   ///< proven: nothing can come between
  hidden, ///< proven: every shadow ray would be blocked
  ray,    ///< by the pixel's own shadow ray to the light that stands for the cluster
  share   ///< estimated, by rays to some of its lights, of the pixel or of its block
};

/// In the order of Sight; as the table and its filter call them.
inline constexpr std::array<const char*, 4> sight_names{"seen", "hidden", "ray", "share"};
[[nodiscard]] inline const char* name_of(Sight sight) { return sight_names[std::size_t(sight)]; }

} // namespace lightcuts::viz
