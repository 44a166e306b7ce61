// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/film.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/colour_map.h>

#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/images/image_file.h>

namespace lightcuts {
namespace {

// Names without a colon pass through OpenImageIO's EXR writer as they are.
constexpr std::string_view metadata_prefix = "lightcuts.";

ImageInfo exr_info(const Film& film) {
  ImageInfo info{.width = static_cast<int>(film.size().x),
                 .height = static_cast<int>(film.size().y),
                 .channels = film.channel_names(),
                 // OpenImageIO would add the time of day.
                 .attributes = {{"compression", "zip"}, {"DateTime", ""}}};
  for (const auto& [key, value] : film.metadata)
    info.attributes[std::string(metadata_prefix) + key] = value;
  return info;
}

std::vector<float> interleaved(const Film& film) {
  const std::size_t stride = film.channel_names().size();
  std::vector<float> pixels(film.pixel_count() * stride);
  for (std::size_t c = 0; c < stride; ++c) {
    const std::span<const float> channel = film.channel(film.channel_names()[c]);
    for (std::size_t i = 0; i < channel.size(); ++i) pixels[i * stride + c] = channel[i];
  }
  return pixels;
}

Film film_of(const ImageInfo& info, std::span<const float> pixels) {
  Film film({info.width, info.height});
  const std::size_t stride = info.channels.size();
  for (std::size_t c = 0; c < stride; ++c) {
    const std::span<float> channel = film.channel(info.channels[c]);
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = pixels[i * stride + c];
  }
  for (const auto& [name, value] : info.attributes)
    if (name.starts_with(metadata_prefix))
      film.metadata[name.substr(metadata_prefix.size())] = value;
  return film;
}

double luminance(const glm::vec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

} // namespace

std::span<float> Film::channel(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return values_[found - names_.begin()];
  names_.emplace_back(name);
  return values_.emplace_back(pixel_count(), 0.0F);
}

std::span<const float> Film::channel(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return {};
  return values_[found - names_.begin()];
}

void write_exr(const Film& film, const std::filesystem::path& file) {
  if (film.pixel_count() == 0 || film.channel_names().empty())
    throw InputError(InputFault::missing, file.string() + ": the film has no pixel or no channel");
  write_image(file, "exr", exr_info(film), interleaved(film).data());
}

Film read_exr(const std::filesystem::path& file) {
  const OpenedImage opened = image_codec().open(file.string());
  if (!opened.reader)
    throw InputError(opening_fault(file), file.string() + ": " + opened.failure.why);
  const ImageInfo& info = opened.reader->info();
  std::vector<float> pixels(info.pixel_count() * info.channels.size());
  if (const auto failure = opened.reader->read(static_cast<int>(info.channels.size()),
                                               SampleType::float32, pixels.data()))
    throw InputError(failure->fault, file.string() + ": " + failure->why);
  return film_of(info, pixels);
}

void write_png(const std::filesystem::path& file, glm::uvec2 size,
               std::span<const glm::vec3> linear_rgb, float exposure) {
  assert(linear_rgb.size() == std::size_t{size.x} * size.y);
  std::vector<Rgb8> pixels(linear_rgb.size());
  std::transform(linear_rgb.begin(), linear_rgb.end(), pixels.begin(), [&](const glm::vec3& rgb) {
    const glm::vec3 exposed = rgb * exposure;
    const bool is_nan = std::isnan(exposed.x) || std::isnan(exposed.y) || std::isnan(exposed.z);
    return is_nan ? nan_colour : srgb8(exposed);
  });
  write_rgb8(file, size, pixels);
}

float automatic_exposure(std::span<const glm::vec3> linear_rgb) {
  std::vector<double> lit;
  for (const glm::vec3& rgb : linear_rgb) {
    const double y = luminance(rgb);
    if (std::isfinite(y) && y > 0) lit.push_back(y);
  }
  if (lit.empty()) return 1;
  const auto percentile = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) * 95 / 100);
  std::nth_element(lit.begin(), percentile, lit.end());
  using Limits = std::numeric_limits<float>;
  return static_cast<float>(
      std::clamp(0.9 / *percentile, double{Limits::min()}, double{Limits::max()}));
}

} // namespace lightcuts
