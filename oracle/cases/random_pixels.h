// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/numerics/splitmix.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts::oracle {

/// 64 random bits, the same for the same arguments.
[[nodiscard]] inline std::uint64_t hashed(std::uint64_t seed, std::uint64_t index) {
  return splitmix64(splitmix64(seed) ^ index);
}

/// A pixel, and the point that it sees.
struct SeenPixel {
  glm::uvec2 pixel;
  VisiblePoint point;
};

/// The index-th random pixel that sees a surface, and what: see random_point().
[[nodiscard]] SeenPixel random_pixel(const SceneView& view, std::uint64_t seed,
                                     std::uint64_t index);

/// The index-th random point that the view sees: uniform over such pixels, with repetition. Throws
/// InputError where 10^5 pixels in a row see nothing.
[[nodiscard]] VisiblePoint random_point(const SceneView& view, std::uint64_t seed,
                                        std::uint64_t index);

} // namespace lightcuts::oracle
