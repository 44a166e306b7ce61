// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include <viz/model/picture/picture.h>

namespace lightcuts::viz {

/// A picture that counts how often each of its pixels is made, and in which order.
class MadeUpPicture : public Picture {
public:
  explicit MadeUpPicture(glm::uvec2 size)
      : Picture(size), times(pixel_count(), 0), values(pixel_count(), 0) {}

  std::vector<int> times;
  std::vector<std::uint32_t> values; ///< of pixel i, once it is made: i + 1
  std::vector<glm::uvec2> order;
  std::function<void()> before_pixel = [] {};
  int calls = 0; ///< of make()

protected:
  void make(const std::function<bool(glm::uvec2)>& wanted, const Progress& progress) override {
    ++calls;
    for (unsigned y = 0; y < size().y; ++y)
      for (unsigned x = 0; x < size().x; ++x) {
        if (!wanted({x, y})) continue;
        before_pixel();
        if (progress.cancelled()) return;
        const std::uint32_t i = y * size().x + x;
        ++times[i];
        values[i] = i + 1;
        order.emplace_back(x, y);
        done({{x, y}, {x + 1, y + 1}});
      }
  }
};

} // namespace lightcuts::viz
