// SPDX-License-Identifier: MIT
#include <viz/model/layers/layer_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <viz/model/layers/histogram.h>

namespace lightcuts::viz {
namespace {

double sum(const glm::vec3& v) { return double(v.x) + v.y + v.z; }

/// Of one pixel of the frame, index i.
class PixelOf {
public:
  PixelOf(const LayerSources& sources)
      : picture_(sources.frame->rendering()),
        reference_(sources.reference ? &sources.reference->rendering() : nullptr),
        truth_(sources.truth.get()), least_(3 * double(sources.frame->cut().black_level)) {}

  [[nodiscard]] float value(Layer layer, std::size_t i) const {
    switch (layer) {
    case Layer::cut_size:
      return picture_.cut_size[i];
    case Layer::shadow_rays:
      return picture_.shadow_rays[i];
    case Layer::time:
      return picture_.microseconds[i];
    case Layer::error:
      return relative(error(i), reference_->radiance[i]);
    case Layer::certified_error:
      return relative(sum(picture_.certified_error[i]), picture_.radiance[i]);
    case Layer::slack: {
      const double e = error(i);
      return e == 0 ? 0 : float(sum(picture_.certified_error[i]) / e);
    }
    case Layer::clairvoyant:
      return truth_->clairvoyant()[i];
    case Layer::violations:
      return truth_->violations()[i];
    case Layer::image:
      break;
    }
    return 0;
  }

private:
  [[nodiscard]] double error(std::size_t i) const {
    const glm::dvec3 difference =
        glm::dvec3(picture_.radiance[i]) - glm::dvec3(reference_->radiance[i]);
    // Both beyond the largest float: equal, as far as can be told.
    double e = 0;
    for (int c = 0; c < 3; ++c)
      if (picture_.radiance[i][c] != reference_->radiance[i][c]) e += std::abs(difference[c]);
    return e;
  }
  [[nodiscard]] float relative(double e, const glm::vec3& radiance) const {
    const double of = std::max(sum(radiance), least_);
    return e == 0 ? 0 : float(e / of);
  }

  const Rendering& picture_;
  const Rendering* reference_;
  const TruthPicture* truth_;
  double least_;
};

/// Per pixel the pixel that stands for it in all pictures that the layer needs.
std::vector<std::uint32_t> common_sources(Layer layer, const LayerSources& sources) {
  if (needs_truth(layer)) return sources.truth->sources();
  std::vector<std::uint32_t> from = sources.frame->sources();
  if (!needs_reference(layer)) return from;
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
  if (needs_truth(layer)) return sources.truth->version();
  return sources.frame->version() + (needs_reference(layer) ? sources.reference->version() : 0);
}

LayerValues layer_values(Layer layer, const LayerSources& sources) {
  const std::vector<std::uint32_t> from = common_sources(layer, sources);
  const Rendering& picture = sources.frame->rendering();
  LayerValues result;
  result.size = sources.frame->size();
  result.known.assign(from.size(), 0);
  result.own.assign(from.size(), 0);
  result.surface.assign(from.size(), 0);
  if (layer == Layer::image)
    result.image.assign(from.size(), glm::vec3(0));
  else
    result.values.assign(from.size(), 0);
  const PixelOf pixel(sources);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::uint32_t source = from[i];
    if (source == Picture::unknown) continue;
    result.known[i] = 1;
    result.own[i] = source == i;
    if (layer == Layer::image) {
      result.image[i] = picture.radiance[source] + picture.emission[source];
      result.surface[i] = picture.cut_size[source] > 0;
      continue;
    }
    result.values[i] = pixel.value(layer, source);
    result.surface[i] = needs_truth(layer) ? sources.truth->clairvoyant()[source] > 0
                                           : picture.cut_size[source] > 0;
  }
  return result;
}

std::optional<float> layer_value(Layer layer, const LayerSources& sources, glm::uvec2 pixel) {
  const std::uint32_t own = pixel.y * sources.frame->size().x + pixel.x;
  const auto knows = [&](const Picture* picture) { return picture->source_of(pixel) == own; };
  if (needs_truth(layer) && !knows(sources.truth.get())) return std::nullopt;
  if (needs_reference(layer) && !knows(sources.reference.get())) return std::nullopt;
  if (!needs_truth(layer) && !knows(sources.frame.get())) return std::nullopt;
  const bool surface = needs_truth(layer) ? sources.truth->clairvoyant()[own] > 0
                                          : sources.frame->rendering().cut_size[own] > 0;
  return surface ? std::optional(PixelOf(sources).value(layer, own)) : std::nullopt;
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
