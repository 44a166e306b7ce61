// SPDX-License-Identifier: MIT
#include <viz/model/picture/display_method.h>

#include <algorithm>
#include <iterator>

namespace lightcuts::viz {

const char* name_of(const DisplayMethod& display) {
  return display.is_raster() ? "raster" : lightcuts::name_of(display.method());
}

std::optional<DisplayMethod> display_named(std::string_view name) {
  for (const DisplayMethod& display : all_displays)
    if (name == name_of(display)) return display;
  return std::nullopt;
}

const char* meaning_of(const DisplayMethod& display) {
  if (display.is_raster())
    return "Rasterised by OpenGL: all lights, Cook-Torrance, no shadows. A preview.";
  switch (display.method()) {
  case Method::reference:
    return "Every light on its own: exact but for rounding.";
  case Method::unscaled:
    return "The paper's cut, its representatives not scaled to their clusters: too dark.";
  case Method::paper:
    return "Lightcuts as published: product bound, random representative, scaled.";
  case Method::stochastic_intensity:
    return "One light drawn for each cluster of a cut, by intensity: unbiased, with noise.";
  case Method::stochastic:
    return "One light drawn for each cluster of a cut, by hierarchical importance: unbiased.";
  case Method::no_specular_bound:
    return "Lightcuts whose glossy lobes are bounded by their peaks: larger cuts.";
  case Method::lightcuts:
    return "Lightcuts: joint bound, estimates at the centroid of intensity.";
  }
  return "";
}

DisplayMethod next(const DisplayMethod& display, int direction) {
  constexpr int count = int(std::size(all_displays));
  const auto* at = std::find(std::begin(all_displays), std::end(all_displays), display);
  const int index = int(at - std::begin(all_displays));
  return all_displays[((index + direction) % count + count) % count];
}

} // namespace lightcuts::viz
