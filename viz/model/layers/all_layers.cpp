// SPDX-License-Identifier: MIT
#include <viz/model/layers/all_layers.h>

#include <algorithm>
#include <iterator>

namespace lightcuts::viz {

Layer next(Layer layer, int direction) {
  constexpr int count = int(std::size(all_layers));
  const auto* at = std::find(std::begin(all_layers), std::end(all_layers), layer);
  return all_layers[(int(at - std::begin(all_layers)) + direction + count) % count];
}

} // namespace lightcuts::viz
