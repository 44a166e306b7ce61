// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/colour_map.h>

namespace lightcuts {

/// How samples lie in memory; of the integers the whole range stands for 0 to 1.
enum class SampleType : std::uint8_t { uint8, uint16, float32 };

/// An image but for its samples, which lie row by row from the top left, channels interleaved.
struct ImageInfo {
  int width = 0, height = 0, depth = 1;          ///< pixels; depth above 1: a volume
  bool cropped = false;                          ///< covers only part of what it is a picture of
  SampleType type = SampleType::float32;         ///< the narrowest that holds what the file stores
  std::vector<std::string> channels;             ///< names, R, G and B first where there are such
  std::map<std::string, std::string> attributes; ///< else what the file says in text
  std::string format;              ///< of a file that is read, such as "png" or "openexr"
  std::uintmax_t stored_bytes = 0; ///< of its samples as they are stored, whole tiles, but not
                                   ///< compressed

  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Why an image was not read or written; `why` does not name the file, and may have many lines.
struct ImageFailure {
  InputFault fault;
  std::string why;
};

/// An image file that has been opened.
class ImageReader {
public:
  virtual ~ImageReader() = default;
  [[nodiscard]] virtual const ImageInfo& info() const noexcept = 0;

  /// Writes the first `channels` channels of all pixels to `samples`, converted to `type`.
  [[nodiscard]] virtual std::optional<ImageFailure> read(int channels, SampleType type,
                                                         void* samples) noexcept = 0;
};

/// A file's reader, or why there is none.
struct OpenedImage {
  std::unique_ptr<ImageReader> reader; ///< null: see failure
  ImageFailure failure{};
};

/// Where and how a line of text is drawn; x and y, in pixels, are those of its baseline's left end.
struct TextStyle {
  int x = 0, y = 0;
  int font_size = 14; ///< pixels
  const char* font;   ///< a name like "DejaVuSans"
};

/// All that this library wants of OpenImageIO, which brings 260 shared libraries and 0.4 s of
/// processor time to load: so it lies behind a module that is loaded where an image is first
/// touched. Nothing throws, since exceptions are not to cross the module's border. Safe to call
/// from many threads.
class ImageCodec {
public:
  virtual ~ImageCodec() = default;

  /// The kind of file goes by its content and extension. The failure's fault is malformed_file.
  [[nodiscard]] virtual OpenedImage open(const std::string& file) const noexcept = 0;

  /// Opens a file's `bytes`, which have to outlive the reader, as of the kind that `extension`
  /// (without a dot) says; `name` is for messages. Colours do not come multiplied by alpha.
  /// Faults: unsupported where files of that kind cannot be read from memory, else malformed_file.
  [[nodiscard]] virtual OpenedImage open_bytes(std::string_view bytes, const std::string& extension,
                                               const std::string& name) const noexcept = 0;

  /// Writes samples of type `info.type` as `format` ("exr", "png"), whatever the file's extension.
  [[nodiscard]] virtual std::optional<ImageFailure> write(const std::string& file,
                                                          const std::string& format,
                                                          const ImageInfo& info,
                                                          const void* samples) const noexcept = 0;

  /// The linear colours of the map of that name (see ColourMap) in equal steps from its first to
  /// its last; black where there is no such map.
  virtual void colour_ramp(const char* map, std::span<glm::vec3> colours) const noexcept = 0;

  /// The width of `text` in pixels; nothing where the font is missing.
  [[nodiscard]] virtual std::optional<int> text_width(const std::string& text,
                                                      const TextStyle& style) const noexcept = 0;

  /// Draws white text on width x height pixels; false where the font is missing.
  [[nodiscard]] virtual bool draw_text(std::span<Rgb8> pixels, int width, int height,
                                       const std::string& text,
                                       const TextStyle& style) const noexcept = 0;
};

/// The symbol by which a module hands out its codec, and its type.
inline constexpr const char* image_codec_symbol = "lightcuts_image_codec";
using ImageCodecFunction = const ImageCodec* (*)();

/// Loads the module that reads and writes images, for as long as the process lives. Throws
/// InputError, naming the module, where it cannot be loaded or is none.
[[nodiscard]] const ImageCodec& load_image_codec(const std::filesystem::path& module);

/// The codec of lightcuts_image_codec.so beside the program, else where it was built; loaded when
/// first asked for. Throws InputError as load_image_codec() does, whenever asked.
[[nodiscard]] const ImageCodec& image_codec();

} // namespace lightcuts
