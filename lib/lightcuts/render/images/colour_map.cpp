// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/colour_map.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/images/image_file.h>

namespace lightcuts {
namespace {

std::uint8_t encoded(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

using Table = std::array<Rgb8, 256>;

Table make_table(ColourMap map) {
  std::array<glm::vec3, std::tuple_size_v<Table>> linear{};
  image_codec().colour_ramp(name_of(map), linear);
  Table table;
  std::transform(linear.begin(), linear.end(), table.begin(), srgb8);
  return table;
}

void validate(const HeatMapScale& scale, const std::filesystem::path& file) {
  const bool finite = std::isfinite(scale.lo) && std::isfinite(scale.hi);
  if (!finite || scale.lo > scale.hi)
    throw InputError(finite ? InputFault::inconsistent : InputFault::not_finite,
                     file.string() + ": the colour scale needs finite lo <= hi");
  if (scale.logarithmic && scale.lo <= 0)
    throw InputError(InputFault::out_of_domain,
                     file.string() + ": a logarithmic colour scale needs lo > 0");
}

// The strip below the picture, in pixels: a margin, the bar, a line of text.
constexpr int margin = 6, bar_height = 12, text_height = 20;
constexpr int strip_height = margin + bar_height + text_height;
constexpr TextStyle text_style{.font_size = 14, .font = "DejaVuSans"};
constexpr Rgb8 strip_colour{32, 32, 32};

// The strip's margins at the sides vanish in pictures too narrow for them.
int side_margin(int width) { return width > 8 * margin ? margin : 0; }

struct Label {
  std::string text;
  int begin, end; // x
};

Label label(float value, int width, float at) {
  const std::string text = fmt::format("{:.4g}", value);
  const int text_width = image_codec().text_width(text, text_style).value_or(width);
  const int side = side_margin(width);
  const int begin = side + static_cast<int>(at * static_cast<float>(width - 2 * side - text_width));
  return {text, begin, begin + text_width};
}

// As many of the three numbers as fit side by side.
std::vector<Label> labels(const HeatMapScale& scale, int width) {
  const Label low = label(scale.lo, width, 0), high = label(scale.hi, width, 1);
  const Label middle = label(value_at(0.5F, scale), width, 0.5F);
  if (low.end + margin > high.begin) return {};
  if (low.end + margin > middle.begin || middle.end + margin > high.begin) return {low, high};
  return {low, middle, high};
}

void draw_bar(std::span<Rgb8> image, int width, int top) {
  const int side = side_margin(width), length = width - 2 * side;
  for (int x = 0; x < length; ++x) {
    const float fraction = length > 1 ? static_cast<float>(x) / static_cast<float>(length - 1) : 0;
    for (int y = 0; y < bar_height; ++y)
      image[static_cast<std::size_t>(top + y) * width + side + x] = heat_colour(fraction, {});
  }
}

void draw_labels(std::span<Rgb8> image, int width, int height, const HeatMapScale& scale) {
  TextStyle style = text_style;
  style.y = height - margin;
  for (const Label& l : labels(scale, width)) {
    style.x = l.begin;
    // Without the font the picture is still worth writing.
    if (!image_codec().draw_text(image, width, height, l.text, style)) return;
  }
}

} // namespace

Rgb8 srgb8(const glm::vec3& linear) {
  return {encoded(linear.x), encoded(linear.y), encoded(linear.z)};
}

float fraction_of(float value, const HeatMapScale& scale) {
  if (value <= scale.lo) return 0;
  if (value >= scale.hi) return 1;
  const double v = value, lo = scale.lo, hi = scale.hi;
  return static_cast<float>(scale.logarithmic ? std::log(v / lo) / std::log(hi / lo)
                                              : (v - lo) / (hi - lo));
}

float value_at(float fraction, const HeatMapScale& scale) {
  const double lo = scale.lo, hi = scale.hi;
  return static_cast<float>(scale.logarithmic ? lo * std::pow(hi / lo, fraction)
                                              : lo + fraction * (hi - lo));
}

Rgb8 heat_colour(float value, const HeatMapScale& scale, ColourMap map) {
  if (std::isnan(value)) return nan_colour;
  if (std::isinf(value)) return value > 0 ? infinity_colour : negative_infinity_colour;
  static const auto tables = [] {
    std::array<Table, std::size(all_colour_maps)> made;
    for (const ColourMap m : all_colour_maps) made[std::size_t(m)] = make_table(m);
    return made;
  }();
  const Table& table = tables[std::size_t(map)];
  return table[std::lround(fraction_of(value, scale) * (table.size() - 1))];
}

void write_heat_map(const std::filesystem::path& file, glm::uvec2 size,
                    std::span<const float> values, const HeatMapScale& scale) {
  validate(scale, file);
  assert(values.size() == std::size_t{size.x} * size.y);
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y) + strip_height;
  std::vector<Rgb8> image(std::size_t{size.x} * static_cast<std::size_t>(height), strip_colour);
  std::transform(values.begin(), values.end(), image.begin(),
                 [&](float value) { return heat_colour(value, scale); });
  draw_bar(image, width, static_cast<int>(size.y) + margin);
  draw_labels(image, width, height, scale);
  write_rgb8(file, {width, height}, image);
}

void write_png(const std::filesystem::path& file, glm::uvec2 size, std::span<const Rgb8> pixels) {
  assert(pixels.size() == std::size_t{size.x} * size.y);
  write_rgb8(file, size, pixels);
}

} // namespace lightcuts
