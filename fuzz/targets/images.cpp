// SPDX-License-Identifier: MIT
// EXR, HDR, PNG and other images, as a texture and as an environment map.
#include <algorithm>
#include <cstdint>

#include <lightcuts/render/images/environment_map.h>
#include <lightcuts/render/images/texture_decoding.h>

#include <fuzz/support/files.h>

namespace lightcuts::fuzz {
namespace {

const char* extension_of(const std::string& bytes) {
  if (bytes.starts_with("v/1\x01")) return ".exr";
  if (bytes.starts_with("#?")) return ".hdr";
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xff\xd8\xff")) return ".jpg";
  if (bytes.starts_with("BM")) return ".bmp";
  if (bytes.starts_with("II*") || bytes.starts_with("MM")) return ".tif";
  return ".tga";
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += char(number >> shift & 255);
  return bytes;
}

/// ISO 3309's, as PNG has it.
std::uint32_t checksum(const std::string& bytes) {
  std::uint32_t sum = ~0U;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320U : 0);
  }
  return ~sum;
}

constexpr const char* png_signature = "\x89PNG\r\n\x1a\n";

/// A PNG's chunks are changed one at a time, so that their lengths and checksums are right: a
/// reader does not go on where they are not.
std::string mutated_image(const std::string& input, gen::Dice& dice, const Bytewise& bytewise) {
  constexpr std::size_t signature = 8, around = 12;
  if (!input.starts_with(png_signature)) return bytewise(input);
  std::string output = png_signature;
  for (std::size_t at = signature; at + around <= input.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i)
      size = size << 8 | static_cast<unsigned char>(input[at + i]);
    size = std::min(size, input.size() - at - around);
    std::string type = input.substr(at + 4, 4), content = input.substr(at + 8, size);
    if (dice.one_in(3)) content = bytewise(content);
    if (dice.one_in(16)) type = dice.pick({"IHDR", "PLTE", "tRNS", "gAMA", "iCCP", "IDAT", "IEND"});
    output += big_endian(std::uint32_t(content.size())) + type + content +
              big_endian(checksum(type + content));
    at += around + size;
  }
  return output;
}

void run_images(Bytes input) {
  static const WorkFolder folder;
  const std::string bytes = text_of(input), name = std::string("fuzzed") + extension_of(bytes);
  try {
    (void)decode_texture(bytes, name);
  } catch (const InputError& error) { // whoever wants the texture names it
    require_message(error.what(), "");
  }
  const auto file = folder.put(name, bytes);
  read_or_refused(name, [&] { validate(read_environment(file)); });
}

const Registered images({"images", run_images, mutated_image});

} // namespace
} // namespace lightcuts::fuzz
