// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

#include <OpenImageIO/imageio.h>
#include <glm/vec2.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/colour_map.h>

namespace lightcuts {

/// Why an image file could not be opened.
inline InputFault opening_fault(const std::filesystem::path& file) {
  std::error_code error;
  const bool readable = std::filesystem::is_regular_file(file, error) && std::ifstream(file);
  return readable ? InputFault::malformed_file : InputFault::unreadable_file;
}

/// Writes pixels of type `type` as `format` ("exr", "png"), whatever the file's extension. Throws
/// InputError with the file's name and OpenImageIO's message.
inline void write_image(const std::filesystem::path& file, const std::string& format,
                        const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                        const void* pixels) {
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) throw InputError(InputFault::unsupported, file.string() + ": " + OIIO::geterror());
  if (!output->open(file.string(), spec) || !output->write_image(type, pixels) || !output->close())
    throw InputError(InputFault::unwritable_file, file.string() + ": " + output->geterror());
}

/// Writes an 8-bit sRGB PNG, size.x * size.y pixels.
inline void write_rgb8(const std::filesystem::path& file, glm::uvec2 size,
                       std::span<const Rgb8> pixels) {
  static_assert(sizeof(Rgb8) == 3);
  OIIO::ImageSpec spec(static_cast<int>(size.x), static_cast<int>(size.y), 3,
                       OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write_image(file, "png", spec, OIIO::TypeDesc::UINT8, pixels.data());
}

} // namespace lightcuts
