// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/texture_decoding.h>

#include <cmath>
#include <limits>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
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

template <class Component>
Texture read(OIIO::ImageInput& input, const OIIO::TypeDesc& type, glm::uvec2 size) {
  // One channel is grey, two are grey and alpha.
  const int channels = input.spec().nchannels < 3 ? 1 : 3;
  std::vector<Component> pixels(std::size_t{size.x} * size.y * channels);
  if (!input.read_image(0, 0, 0, channels, type, pixels.data()))
    throw InputError(InputFault::malformed_file, why(input.geterror()));
  std::vector<glm::vec3> texels(std::size_t{size.x} * size.y);
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      texels[i][c] = linear_of(pixels[i * channels + (channels == 1 ? 0 : c)]);
  return {size, std::move(texels)};
}

/// Refused before memory is asked for that a broken header wants.
glm::uvec2 size_of(const OIIO::ImageSpec& spec) {
  constexpr int most = max_texture_side;
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.width > most || spec.height > most)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("an image of {} x {} x {} pixels, expected 1 to {} on a side",
                                 spec.width, spec.height, spec.depth, most));
  return {spec.width, spec.height};
}

} // namespace

Texture decode_texture(std::string_view bytes, const std::string& name) {
  const std::string extension = extension_of(bytes, name);
  const auto input = extension.empty() ? nullptr : OIIO::ImageInput::create(extension);
  // A reader without proxies would look for a file.
  if (!input || !input->supports("ioproxy"))
    throw InputError(InputFault::unsupported, fmt::format("unknown kind of image '{}'", extension));
  // The reader would fill the rest of such an image with grey.
  if (extension == "jpg" && bytes.find("\xff\xd9") == std::string_view::npos)
    throw InputError(InputFault::malformed_file, "truncated: no end of image");
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  OIIO::Filesystem::IOProxy* proxy = &memory;
  OIIO::ImageSpec spec, config;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  config.attribute("oiio:UnassociatedAlpha", 1); // else colours come multiplied by alpha
  if (!input->open(name, spec, config))
    throw InputError(InputFault::malformed_file, why(input->geterror()));
  const glm::uvec2 size = size_of(spec);
  require_plausible_size(spec, bytes.size(), input->format_name());
  if (spec.format.is_floating_point()) return read<float>(*input, OIIO::TypeDesc::FLOAT, size);
  if (spec.format.size() == 1) return read<std::uint8_t>(*input, OIIO::TypeDesc::UINT8, size);
  return read<std::uint16_t>(*input, OIIO::TypeDesc::UINT16, size);
}

} // namespace lightcuts
