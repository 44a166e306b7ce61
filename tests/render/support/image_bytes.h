// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include <tests/render/support/temporary_folder.h>

namespace lightcuts::test {

/// The bytes of an image file of the kind that `extension` says, its pixels row by row from the
/// top; the last of 2 or 4 channels is alpha, by which the others are not multiplied.
template <class Component>
std::string image_bytes(const std::string& extension, int width, int channels,
                        const std::vector<Component>& pixels) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / ("image." + extension);
  const OIIO::TypeDesc type(OIIO::BaseTypeFromC<Component>::value);
  OIIO::ImageSpec spec(width, static_cast<int>(pixels.size()) / (width * channels), channels, type);
  if (channels % 2 == 0) spec.alpha_channel = channels - 1;
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(file.string());
  if (!output || !output->open(file.string(), spec) || !output->write_image(type, pixels.data()) ||
      !output->close())
    throw std::runtime_error("cannot write a test image: " + extension);
  return content_of(file);
}

/// A PNG of 2 x 2 pixels: red and green above blue and white.
inline std::string four_colours() {
  return image_bytes<std::uint8_t>("png", 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
}

} // namespace lightcuts::test
