// SPDX-License-Identifier: MIT
#include <viz/gl/scene/random_order.h>

#include <numeric>
#include <utility>

#include <lightcuts/core/numerics/splitmix.h>

namespace lightcuts::viz {

// Fisher & Yates.
std::vector<std::uint32_t> random_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[splitmix64(i * splitmix64_step) % i]);
  return order;
}

} // namespace lightcuts::viz
