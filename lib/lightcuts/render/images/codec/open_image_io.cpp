// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/image_codec.h>

#include <array>
#include <cstdint>
#include <exception>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

namespace lightcuts {
namespace {

/// What action() returns; `otherwise(message)` where it throws.
template <class Action, class Otherwise>
auto guarded(const Action& action, const Otherwise& otherwise) noexcept -> decltype(action()) {
  try {
    return action();
  } catch (const std::exception& error) {
    return otherwise(error.what());
  } catch (...) {
    return otherwise("unknown error");
  }
}

OIIO::TypeDesc type_of(SampleType type) {
  switch (type) {
  case SampleType::uint8:
    return OIIO::TypeDesc::UINT8;
  case SampleType::uint16:
    return OIIO::TypeDesc::UINT16;
  case SampleType::float32:
    break;
  }
  return OIIO::TypeDesc::FLOAT;
}

SampleType sample_type_of(const OIIO::TypeDesc& type) {
  if (type.is_floating_point()) return SampleType::float32;
  return type.size() == 1 ? SampleType::uint8 : SampleType::uint16;
}

/// Of all samples, tiles being read as a whole: one may be larger than the image.
std::uintmax_t stored_bytes(const OIIO::ImageSpec& spec) {
  const auto whole = [](int size, int tile) {
    const std::uintmax_t one = tile > 0 ? tile : 1;
    return (std::uintmax_t(size) + one - 1) / one * one;
  };
  return whole(spec.width, spec.tile_width) * whole(spec.height, spec.tile_height) *
         std::uintmax_t(spec.depth) * spec.pixel_bytes(true);
}

ImageInfo info_of(const OIIO::ImageInput& input) {
  const OIIO::ImageSpec& spec = input.spec();
  ImageInfo info{.width = spec.width,
                 .height = spec.height,
                 .depth = spec.depth,
                 .cropped = spec.x != spec.full_x || spec.y != spec.full_y ||
                            spec.width != spec.full_width || spec.height != spec.full_height,
                 .type = sample_type_of(spec.format),
                 .channels = spec.channelnames,
                 .attributes = {},
                 .format = input.format_name(),
                 .stored_bytes = stored_bytes(spec)};
  info.channels.resize(spec.nchannels);
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeDesc::STRING)
      info.attributes[attribute.name().string()] = attribute.get_string();
  return info;
}

OIIO::ImageSpec spec_of(const ImageInfo& info) {
  OIIO::ImageSpec spec(info.width, info.height, static_cast<int>(info.channels.size()),
                       type_of(info.type));
  spec.channelnames = info.channels;
  for (const auto& [name, value] : info.attributes) spec.attribute(name, value);
  return spec;
}

class Reader final : public ImageReader {
public:
  explicit Reader(std::unique_ptr<OIIO::ImageInput> input)
      : input_(std::move(input)), info_(info_of(*input_)) {}

  /// Of a file in memory.
  Reader(std::unique_ptr<OIIO::Filesystem::IOMemReader> memory,
         std::unique_ptr<OIIO::ImageInput> input)
      : memory_(std::move(memory)), input_(std::move(input)), info_(info_of(*input_)) {}

  [[nodiscard]] const ImageInfo& info() const noexcept override { return info_; }

  [[nodiscard]] std::optional<ImageFailure> read(int channels, SampleType type,
                                                 void* samples) noexcept override {
    return guarded(
        [&]() -> std::optional<ImageFailure> {
          if (input_->read_image(0, 0, 0, channels, type_of(type), samples)) return std::nullopt;
          return ImageFailure{InputFault::malformed_file, input_->geterror()};
        },
        [](const char* why) {
          return ImageFailure{InputFault::malformed_file, why};
        });
  }

private:
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_; ///< outlives what reads it
  std::unique_ptr<OIIO::ImageInput> input_;
  ImageInfo info_;
};

OpenedImage failure(InputFault fault, std::string why) {
  return {nullptr, {fault, std::move(why)}};
}

OpenedImage malformed(const char* why) { return failure(InputFault::malformed_file, why); }

OpenedImage open_memory(std::string_view bytes, const std::string& extension,
                        const std::string& name) {
  auto input = extension.empty() ? nullptr : OIIO::ImageInput::create(extension);
  // A reader without proxies would look for a file.
  if (!input || !input->supports("ioproxy"))
    return failure(InputFault::unsupported, "unknown kind of image '" + extension + "'");
  auto memory = std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size());
  OIIO::Filesystem::IOProxy* proxy = memory.get();
  OIIO::ImageSpec spec, config;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(name, spec, config))
    return failure(InputFault::malformed_file, input->geterror());
  return {std::make_unique<Reader>(std::move(memory), std::move(input))};
}

class OpenImageIo final : public ImageCodec {
public:
  [[nodiscard]] OpenedImage open(const std::string& file) const noexcept override {
    return guarded(
        [&]() -> OpenedImage {
          auto input = OIIO::ImageInput::open(file);
          if (!input) return failure(InputFault::malformed_file, OIIO::geterror());
          return {std::make_unique<Reader>(std::move(input))};
        },
        malformed);
  }

  [[nodiscard]] OpenedImage open_bytes(std::string_view bytes, const std::string& extension,
                                       const std::string& name) const noexcept override {
    return guarded([&] { return open_memory(bytes, extension, name); }, malformed);
  }

  [[nodiscard]] std::optional<ImageFailure> write(const std::string& file,
                                                  const std::string& format, const ImageInfo& info,
                                                  const void* samples) const noexcept override {
    return guarded(
        [&]() -> std::optional<ImageFailure> {
          const auto output = OIIO::ImageOutput::create(format);
          if (!output) return ImageFailure{InputFault::unsupported, OIIO::geterror()};
          if (output->open(file, spec_of(info)) &&
              output->write_image(type_of(info.type), samples) && output->close())
            return std::nullopt;
          return ImageFailure{InputFault::unwritable_file, output->geterror()};
        },
        [](const char* why) {
          return ImageFailure{InputFault::unwritable_file, why};
        });
  }

  void colour_ramp(const char* map, std::span<glm::vec3> colours) const noexcept override {
    guarded(
        [&] {
          const int size = static_cast<int>(colours.size());
          std::vector<float> ramp(colours.size());
          for (int i = 0; i < size; ++i)
            ramp[i] = static_cast<float>(i) / static_cast<float>(size - 1);
          const OIIO::ImageSpec spec(size, 1, 1, OIIO::TypeDesc::FLOAT);
          const OIIO::ImageBuf source(spec, ramp.data());
          const OIIO::ImageBuf image = OIIO::ImageBufAlgo::color_map(source, 0, map);
          for (int i = 0; i < size; ++i) {
            std::array<float, 3> linear{};
            image.getpixel(i, 0, linear.data(), 3);
            colours[i] = {linear[0], linear[1], linear[2]};
          }
        },
        [](const char* /*why*/) {});
  }

  [[nodiscard]] std::optional<int> text_width(const std::string& text,
                                              const TextStyle& style) const noexcept override {
    return guarded(
        [&]() -> std::optional<int> {
          const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, style.font_size, style.font);
          return box.defined() ? std::optional(box.width()) : std::nullopt;
        },
        [](const char* /*why*/) { return std::nullopt; });
  }

  [[nodiscard]] bool draw_text(std::span<Rgb8> pixels, int width, int height,
                               const std::string& text,
                               const TextStyle& style) const noexcept override {
    return guarded(
        [&] {
          const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
          OIIO::ImageBuf image(spec, pixels.data());
          constexpr std::array<float, 3> white{1, 1, 1};
          return OIIO::ImageBufAlgo::render_text(image, style.x, style.y, text, style.font_size,
                                                 style.font, white);
        },
        [](const char* /*why*/) { return false; });
  }
};

} // namespace
} // namespace lightcuts

extern "C" const lightcuts::ImageCodec* lightcuts_image_codec() {
  static const lightcuts::OpenImageIo codec;
  return &codec;
}
