// SPDX-License-Identifier: MIT
#include <viz/model/layers/colouring.h>

#include <array>
#include <cmath>

#include <lightcuts/render/images/film.h>

namespace lightcuts::viz {
namespace {

/// srgb8() by table, which is many times as fast: 2^14 steps are finer than 8 bits everywhere, in
/// the dark, where the curve is steepest, five times.
class SrgbTable {
public:
  SrgbTable() {
    for (std::size_t i = 0; i < table_.size(); ++i)
      table_[i] = srgb8(glm::vec3(float(i) / float(table_.size() - 1))).r;
  }
  [[nodiscard]] Rgb8 operator()(const glm::vec3& c) const { return {at(c.r), at(c.g), at(c.b)}; }

private:
  [[nodiscard]] std::uint8_t at(float v) const {
    if (!(v > 0)) return 0;
    const float last = float(table_.size() - 1);
    return v >= 1 ? 255 : table_[std::size_t(std::lround(v * last))];
  }
  std::array<std::uint8_t, 16384> table_{};
};

Rgb8 shown(const glm::vec3& radiance, float exposure) {
  static const SrgbTable srgb;
  for (int c = 0; c < 3; ++c)
    if (std::isnan(radiance[c])) return nan_colour;
  for (int c = 0; c < 3; ++c)
    if (std::isinf(radiance[c])) return infinity_colour;
  return srgb(radiance * exposure);
}

/// Of a heat map the colour by table: 256 steps, as many as the map has.
class Ramp {
public:
  Ramp(const HeatMapScale& scale, ColourMap map) : scale_(scale) {
    for (std::size_t i = 0; i < colours_.size(); ++i)
      colours_[i] = heat_colour(float(i) / float(colours_.size() - 1), {}, map);
  }
  [[nodiscard]] Rgb8 operator()(float value) const {
    if (!std::isfinite(value)) return heat_colour(value, scale_);
    const float fraction = fraction_of(value, scale_);
    return colours_[std::size_t(std::lround(fraction * float(colours_.size() - 1)))];
  }

private:
  HeatMapScale scale_;
  std::array<Rgb8, 256> colours_;
};

std::vector<glm::vec3> known_radiance(const LayerValues& values) {
  std::vector<glm::vec3> known;
  for (std::size_t i = 0; i < values.image.size(); ++i)
    if (values.known[i] != 0) known.push_back(values.image[i]);
  return known;
}

void colour_image(const LayerValues& values, Coloured& result) {
  for (std::size_t i = 0; i < values.image.size(); ++i)
    if (values.known[i] != 0) result.pixels[i] = shown(values.image[i], result.exposure);
}

void colour_values(const LayerValues& values, ColourMap map, Coloured& result) {
  const Ramp ramp(result.scale, map);
  for (std::size_t i = 0; i < values.values.size(); ++i)
    if (values.known[i] != 0)
      result.pixels[i] = values.surface[i] != 0 ? ramp(values.values[i]) : nothing_colour;
}

} // namespace

HeatMapScale scale_of(const ColourSettings& settings, const LayerStatistics& statistics) {
  if (settings.automatic_range) return automatic_scale(statistics, settings.logarithmic);
  const bool logarithmic = settings.logarithmic && settings.lo > 0;
  return {settings.lo, settings.hi, logarithmic};
}

Coloured coloured(Layer layer, const LayerValues& values, const ColourSettings& settings,
                  std::optional<float> exposure, const std::optional<HeatMapScale>& scale) {
  Coloured result;
  result.size = values.size;
  result.pixels.assign(values.known.size(), pending_colour);
  result.statistics = statistics_of(values);
  if (layer.is_image()) {
    if (settings.exposure) exposure = settings.exposure;
    result.exposure = exposure ? *exposure : automatic_exposure(known_radiance(values));
    colour_image(values, result);
  } else {
    result.scale = scale.value_or(scale_of(settings, result.statistics));
    colour_values(values, settings.map, result);
  }
  return result;
}

} // namespace lightcuts::viz
