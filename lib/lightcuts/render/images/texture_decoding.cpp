// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/texture_decoding.h>

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/images/plausible_size.h>

namespace lightcuts {
namespace {

/// The linear value of every sRGB code of an integer type.
template <class Code>
std::vector<float> make_table() {
  constexpr std::uint32_t last = std::numeric_limits<Code>::max();
  std::vector<float> table(last + 1);
  for (std::uint32_t code = 0; code <= last; ++code) {
    const double c = double(code) / last;
    const double linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    table[code] = static_cast<float>(linear);
  }
  return table;
}

template <class Code>
float linear_of(Code code) {
  static const std::vector<float> table = make_table<Code>();
  return table[code];
}

float linear_of(float value) { return value; }

/// OpenImageIO chooses the reader by extension; PNGs and JPEGs under a wrong name are common, and
/// in glTF's buffers they have none.
std::string extension_of(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x89PNG")) return "png";
  if (bytes.starts_with("\xff\xd8\xff")) return "jpg";
  const std::string extension = lower_extension(name);
  return extension.empty() ? extension : extension.substr(1);
}

std::string why(const std::string& message) {
  return one_line(message.substr(0, message.find('\n')));
}

/// Refused before memory is asked for that a broken header wants.
glm::uvec2 size_of(const ImageInfo& info) {
  constexpr int most = max_texture_side;
  if (info.width < 1 || info.height < 1 || info.depth > 1 || info.channels.empty() ||
      info.width > most || info.height > most)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("an image of {} x {} x {} pixels, expected 1 to {} on a side",
                                 info.width, info.height, info.depth, most));
  return {info.width, info.height};
}

template <class Component>
Texture read(ImageReader& reader, SampleType type) {
  const glm::uvec2 size = size_of(reader.info());
  // One channel is grey, two are grey and alpha.
  const int channels = reader.info().channels.size() < 3 ? 1 : 3;
  std::vector<Component> pixels(std::size_t{size.x} * size.y * channels);
  if (const auto failure = reader.read(channels, type, pixels.data()))
    throw InputError(failure->fault, why(failure->why));
  std::vector<glm::vec3> texels(std::size_t{size.x} * size.y);
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      texels[i][c] = linear_of(pixels[i * channels + (channels == 1 ? 0 : c)]);
  return {size, std::move(texels)};
}

} // namespace

Texture decode_texture(std::string_view bytes, const std::string& name) {
  const std::string extension = extension_of(bytes, name);
  // The reader would fill the rest of such an image with grey.
  if (extension == "jpg" && bytes.find("\xff\xd9") == std::string_view::npos)
    throw InputError(InputFault::malformed_file, "truncated: no end of image");
  const OpenedImage opened = image_codec().open_bytes(bytes, extension, name);
  if (!opened.reader) throw InputError(opened.failure.fault, why(opened.failure.why));
  size_of(opened.reader->info());
  require_plausible_size(opened.reader->info(), bytes.size());
  switch (const SampleType type = opened.reader->info().type; type) {
  case SampleType::uint8:
    return read<std::uint8_t>(*opened.reader, type);
  case SampleType::uint16:
    return read<std::uint16_t>(*opened.reader, type);
  case SampleType::float32:
    break;
  }
  return read<float>(*opened.reader, SampleType::float32);
}

} // namespace lightcuts
