// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightcuts {

/// An image of named float channels ("R", "reference.R", "cut.size", ...) with metadata. Pixels are
/// stored row by row from the top left.
class Film {
public:
  /// size in pixels.
  explicit Film(glm::uvec2 size) : size_(size) {}

  [[nodiscard]] glm::uvec2 size() const { return size_; }
  [[nodiscard]] std::size_t pixel_count() const { return std::size_t{size_.x} * size_.y; }

  /// The channel of that name, pixel_count() values; added, filled with 0, where there is none.
  /// The span stays valid while the film lives, whatever is added later.
  [[nodiscard]] std::span<float> channel(std::string_view name);

  /// The channel of that name, or an empty span where there is none.
  [[nodiscard]] std::span<const float> channel(std::string_view name) const;

  /// The channels' names in the order of adding.
  [[nodiscard]] const std::vector<std::string>& channel_names() const { return names_; }

  /// Notes kept with the image: scene, seed, threshold, version, ...
  std::map<std::string, std::string> metadata;

private:
  glm::uvec2 size_;
  std::vector<std::string> names_;
  std::vector<std::vector<float>> values_; // per name
};

/// Writes all channels as 32-bit floats, bit by bit, with the metadata under "lightcuts.KEY".
/// Equal films give equal files. Throws InputError, naming the file, where it cannot be written or
/// the film has no pixel or no channel.
void write_exr(const Film& film, const std::filesystem::path& file);

/// Reads a film back: the same bits, NaN and infinities included. The order of channels is the
/// file's (RGB first); entries of metadata with an empty value are not kept by the format. Reads
/// any EXR, converting its channels to float. Throws InputError, naming the file.
[[nodiscard]] Film read_exr(const std::filesystem::path& file);

/// Writes an 8-bit sRGB picture of `linear_rgb` (size.x * size.y values, row by row) times
/// `exposure`, clamped to [0, 1]; a pixel with a NaN is magenta. Throws InputError, naming the
/// file, where it cannot be written.
void write_png(const std::filesystem::path& file, glm::uvec2 size,
               std::span<const glm::vec3> linear_rgb, float exposure);

/// The factor that maps the 95th percentile of the lit pixels' luminance (Rec. 709) to 0.9. Pixels
/// that are black or not finite do not count; 1 where none is left. Always finite and positive.
[[nodiscard]] float automatic_exposure(std::span<const glm::vec3> linear_rgb);

} // namespace lightcuts
