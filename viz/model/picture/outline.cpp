// SPDX-License-Identifier: MIT
#include <viz/model/picture/outline.h>

#include <algorithm>
#include <array>

namespace lightcuts::viz {

std::vector<PixelEdge> outline_of(std::span<const glm::uvec2> pixels) {
  // Left of x = 0 is a number that no pixel has.
  constexpr std::array<glm::uvec2, 4> beside{{{0, ~0U}, {1, 0}, {0, 1}, {~0U, 0}}};
  constexpr std::array<PixelEdge, 4> edges{
      {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}}};
  std::vector<PixelEdge> outline;
  for (const glm::uvec2 pixel : pixels)
    for (std::size_t side = 0; side < beside.size(); ++side)
      if (std::ranges::find(pixels, pixel + beside[side]) == pixels.end())
        outline.push_back({pixel + edges[side].from, pixel + edges[side].to});
  return outline;
}

} // namespace lightcuts::viz
