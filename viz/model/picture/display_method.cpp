// SPDX-License-Identifier: MIT
#include <viz/model/picture/display_method.h>

#include <algorithm>
#include <iterator>

namespace lightcuts::viz {

const char* name_of(const DisplayMethod& display) {
  return display.is_raster() ? "raster" : display.method()->name;
}

const char* meaning_of(const DisplayMethod& display) {
  if (display.is_raster())
    return "Rasterised by OpenGL: all lights, Cook-Torrance, no shadows. A preview.";
  return display.method()->meaning;
}

DisplayMethod next(const DisplayMethod& display, int direction) {
  constexpr int count = int(std::size(all_displays));
  const auto* at = std::find(std::begin(all_displays), std::end(all_displays), display);
  const int index = int(at - std::begin(all_displays));
  return all_displays[((index + direction) % count + count) % count];
}

} // namespace lightcuts::viz
