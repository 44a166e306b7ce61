// SPDX-License-Identifier: MIT
#include <viz/model/layers/layer_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <viz/model/layers/histogram.h>

namespace lightcuts::viz {
namespace {

LayerPixel pixel_of(const LayerSources& sources, std::size_t i) {
  const Rendering* reference = sources.reference ? &sources.reference->rendering() : nullptr;
  return {sources.frame->rendering(),       reference, sources.truth.get(), sources.blocks.get(),
          sources.frame->cut().black_level, i};
}

bool sees_surface(Layer layer, const LayerPixel& p) {
  if (layer.needs_blocks()) return p.blocks->block_size()[p.i] > 0;
  return (layer.needs_truth() ? p.truth->clairvoyant() : p.picture.cut_size)[p.i] > 0;
}

/// Per pixel the pixel that stands for it in all pictures that the layer needs.
std::vector<std::uint32_t> common_sources(Layer layer, const LayerSources& sources) {
  if (const Picture* other = sources.instead_of_frame(layer)) return other->sources();
  std::vector<std::uint32_t> from = sources.frame->sources();
  if (!layer.needs_reference()) return from;
  const std::vector<std::uint32_t> other = sources.reference->sources();
  // Both are known on the coarser of the two grids.
  const unsigned width = sources.frame->size().x;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == Picture::unknown || other[i] == Picture::unknown)
      from[i] = Picture::unknown;
    else if (other[i] != from[i]) // the coarser one's pixel is farther up and left
      from[i] = other[i] / width + other[i] % width < from[i] / width + from[i] % width ? other[i]
                                                                                        : from[i];
  }
  return from;
}

} // namespace

std::uint64_t version_of(Layer layer, const LayerSources& sources) {
  if (const Picture* other = sources.instead_of_frame(layer)) return other->version();
  return sources.frame->version() + (layer.needs_reference() ? sources.reference->version() : 0);
}

LayerValues layer_values(Layer layer, const LayerSources& sources) {
  const std::vector<std::uint32_t> from = common_sources(layer, sources);
  LayerValues result;
  result.size = sources.frame->size();
  result.known.assign(from.size(), 0);
  result.own.assign(from.size(), 0);
  result.surface.assign(from.size(), 0);
  if (layer.is_image())
    result.image.assign(from.size(), glm::vec3(0));
  else
    result.values.assign(from.size(), 0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == Picture::unknown) continue;
    const LayerPixel pixel = pixel_of(sources, from[i]);
    result.known[i] = 1;
    result.own[i] = from[i] == i;
    result.surface[i] = sees_surface(layer, pixel);
    if (layer.is_image())
      result.image[i] = layer->colour(pixel);
    else
      result.values[i] = layer->value(pixel);
  }
  return result;
}

std::optional<float> layer_value(Layer layer, const LayerSources& sources, glm::uvec2 pixel) {
  const std::uint32_t own = pixel.y * sources.frame->size().x + pixel.x;
  const auto knows = [&](const Picture* picture) { return picture->source_of(pixel) == own; };
  const Picture* const other = sources.instead_of_frame(layer);
  if (!knows(other != nullptr ? other : sources.frame.get())) return std::nullopt;
  if (layer.needs_reference() && !knows(sources.reference.get())) return std::nullopt;
  const LayerPixel at = pixel_of(sources, own);
  return sees_surface(layer, at) ? std::optional(layer->value(at)) : std::nullopt;
}

LayerStatistics statistics_of(const LayerValues& layer) {
  LayerStatistics s;
  float least = std::numeric_limits<float>::infinity(), largest = -least, positive = least;
  double total = 0;
  std::vector<float> finite;
  const auto count = [&](float v) {
    if (std::isnan(v)) {
      ++s.nan;
    } else if (std::isinf(v)) {
      ++s.infinite;
    } else {
      least = std::min(least, v);
      largest = std::max(largest, v);
      if (v > 0) positive = std::min(positive, v);
      total += v;
      finite.push_back(v);
    }
  };
  for (std::size_t i = 0; i < layer.known.size(); ++i) {
    if (layer.known[i] == 0 || layer.surface[i] == 0) continue;
    ++s.known;
    if (layer.values.empty())
      for (int c = 0; c < 3; ++c) count(layer.image[i][c]);
    else
      count(layer.values[i]);
  }
  if (finite.empty()) return s;
  s.most_below = percentiles(finite, std::array{99.5}).front();
  s.least = least;
  s.largest = largest;
  s.least_positive = std::isinf(positive) ? 0 : positive;
  s.mean = total / double(finite.size());
  return s;
}

HeatMapScale automatic_scale(const LayerStatistics& statistics, bool logarithmic) {
  constexpr float far = 1.5F;
  const bool outliers =
      statistics.most_below > 0 && statistics.largest > far * statistics.most_below;
  const float largest = outliers ? statistics.most_below : statistics.largest;
  const float hi = std::max(largest, std::numeric_limits<float>::min());
  if (!logarithmic) return {0, hi, false};
  const float lo = statistics.least_positive > 0 ? statistics.least_positive : hi;
  // A scale of one value shows nothing; one decade shows where it lies.
  return {lo < hi ? lo : hi / 10, hi, true};
}

} // namespace lightcuts::viz
