// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

#include <glm/vec2.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/colour_map.h>

#include <lightcuts/render/images/image_codec.h>

namespace lightcuts {

/// Why an image file could not be opened.
inline InputFault opening_fault(const std::filesystem::path& file) {
  std::error_code error;
  const bool readable = std::filesystem::is_regular_file(file, error) && std::ifstream(file);
  return readable ? InputFault::malformed_file : InputFault::unreadable_file;
}

/// Writes samples of type `info.type` as `format` ("exr", "png"), whatever the file's extension.
/// Throws InputError with the file's name and OpenImageIO's message.
inline void write_image(const std::filesystem::path& file, const std::string& format,
                        const ImageInfo& info, const void* samples) {
  if (const auto failure = image_codec().write(file.string(), format, info, samples))
    throw InputError(failure->fault, file.string() + ": " + failure->why);
}

/// Writes an 8-bit sRGB PNG, size.x * size.y pixels.
inline void write_rgb8(const std::filesystem::path& file, glm::uvec2 size,
                       std::span<const Rgb8> pixels) {
  static_assert(sizeof(Rgb8) == 3);
  const ImageInfo info{.width = static_cast<int>(size.x),
                       .height = static_cast<int>(size.y),
                       .type = SampleType::uint8,
                       .channels = {"R", "G", "B"},
                       .attributes = {{"oiio:ColorSpace", "sRGB"}}};
  write_image(file, "png", info, pixels.data());
}

} // namespace lightcuts
