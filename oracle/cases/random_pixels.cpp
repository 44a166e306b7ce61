// SPDX-License-Identifier: MIT
#include <oracle/cases/random_pixels.h>

#include <lightcuts/core/input_error.h>

namespace lightcuts::oracle {

SeenPixel random_pixel(const SceneView& view, std::uint64_t seed, std::uint64_t index) {
  const glm::uvec2 size = view.size();
  const std::uint64_t stream = hashed(seed, index);
  for (std::uint64_t attempt = 0; attempt < 100000; ++attempt) {
    const std::uint64_t bits = hashed(stream, attempt);
    const glm::uvec2 pixel((bits >> 32) % size.x, (bits & 0xffffffffU) % size.y);
    if (const auto p = view.at(pixel)) return {pixel, *p};
  }
  throw InputError(InputFault::missing, view.scene().name + ": the camera sees no surface");
}

VisiblePoint random_point(const SceneView& view, std::uint64_t seed, std::uint64_t index) {
  return random_pixel(view, seed, index).point;
}

} // namespace lightcuts::oracle
