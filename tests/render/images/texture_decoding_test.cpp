// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/texture_decoding.h>

#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/colour_map.h>

#include <tests/render/support/image_bytes.h>
#include <tests/render/support/refusal.h>

namespace lightcuts {
namespace {

using test::image_bytes;

TEST(DecodeTexture, DecodesSrgb) {
  std::vector<std::uint8_t> ramp(256 * 3);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<std::uint8_t>(i / 3);
  const Texture texture = decode_texture(image_bytes("png", 256, 3, ramp), "ramp.png");
  const auto value = [&](int code) { return texture.at({(code + 0.5) / 256, 0.5}); };
  EXPECT_EQ(value(0), glm::vec3(0));
  EXPECT_FLOAT_EQ(value(10).x, 10 / 255.0F / 12.92F); // the last one below the threshold
  EXPECT_FLOAT_EQ(value(11).x, 0.003346536F);
  EXPECT_FLOAT_EQ(value(128).x, 0.21586050F);
  EXPECT_FLOAT_EQ(value(188).x, 0.50288653F);
  EXPECT_EQ(value(255), glm::vec3(1));
  for (int code = 0; code < 256; ++code) EXPECT_EQ(srgb8(value(code)), Rgb8(code));
}

TEST(DecodeTexture, KeepsTheRowsInTheirOrder) {
  const Texture texture = decode_texture(test::four_colours(), "f.png");
  ASSERT_EQ(texture.size(), glm::uvec2(2));
  EXPECT_EQ(texture.at({0.25, 0.75}), glm::vec3(1, 0, 0));
  EXPECT_EQ(texture.at({0.75, 0.75}), glm::vec3(0, 1, 0));
  EXPECT_EQ(texture.at({0.25, 0.25}), glm::vec3(0, 0, 1));
  EXPECT_EQ(texture.at({0.75, 0.25}), glm::vec3(1, 1, 1));
}

TEST(DecodeTexture, ReadsSixteenBitsWithTheirPrecision) {
  const Texture texture =
      decode_texture(image_bytes<std::uint16_t>("png", 1, 3, {1000, 128 * 257, 65535}), "deep.png");
  EXPECT_FLOAT_EQ(texture.at({0, 0}).x, 1000 / 65535.0F / 12.92F);
  EXPECT_FLOAT_EQ(texture.at({0, 0}).y, 0.21586050F);
  EXPECT_EQ(texture.at({0, 0}).z, 1);
}

TEST(DecodeTexture, TakesFloatsAsLinear) {
  const std::vector<float> pixels{0.5F, 3, -0.25F, 0.125F, 0, 1};
  const Texture exr = decode_texture(image_bytes("exr", 2, 3, pixels), "a.exr");
  EXPECT_EQ(exr.at({0.25, 0.5}), glm::vec3(0.5F, 3, 0));
  EXPECT_EQ(exr.at({0.75, 0.5}), glm::vec3(0.125F, 0, 1));
  EXPECT_EQ(exr.clamped(), 1U);
  const Texture hdr = decode_texture(image_bytes<float>("hdr", 1, 3, {0.5F, 2, 0.25F}), "A.HDR");
  EXPECT_EQ(hdr.at({0, 0}), glm::vec3(0.5F, 2, 0.25F));
}

TEST(DecodeTexture, TakesGreyForAllComponents) {
  const glm::vec3 grey(0.21586050F);
  for (const int channels : {1, 2}) {
    std::vector<std::uint8_t> pixel(channels, 128);
    const glm::vec3 colour = decode_texture(image_bytes("png", 1, channels, pixel), "g").at({0, 0});
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(colour[c], grey[c]);
  }
}

TEST(DecodeTexture, DoesNotMultiplyByAlpha) {
  for (const std::string extension : {"png", "tga", "tif"}) {
    const std::string bytes = image_bytes<std::uint8_t>(extension, 1, 4, {255, 128, 0, 64});
    const glm::vec3 colour = decode_texture(bytes, "a." + extension).at({0, 0});
    EXPECT_EQ(colour.x, 1) << extension;
    EXPECT_FLOAT_EQ(colour.y, 0.21586050F) << extension;
  }
}

TEST(DecodeTexture, ReadsJpeg) {
  const std::vector<std::uint8_t> pixels(8 * 8 * 3, 200);
  const glm::vec3 colour = decode_texture(image_bytes("jpg", 8, 3, pixels), "j.jpeg").at({0, 0});
  for (int c = 0; c < 3; ++c) EXPECT_EQ(srgb8(colour)[c], 200);
}

TEST(DecodeTexture, KnowsPngAndJpegUnderAnyName) {
  EXPECT_NO_THROW((void)decode_texture(test::four_colours(), "f.jpg"));
  EXPECT_NO_THROW((void)decode_texture(test::four_colours(), ""));
  const std::vector<std::uint8_t> pixels(8 * 8 * 3, 200);
  EXPECT_NO_THROW((void)decode_texture(image_bytes("jpg", 8, 3, pixels), "j.png"));
}

TEST(DecodeTexture, RefusesWhatIsNoImage) {
  expect_refusal("Not a PNG file", [] { (void)decode_texture("hello", "a.png"); });
  expect_refusal("Not a PNG file", [] { (void)decode_texture("", "a.png"); });
  expect_refusal("unknown kind of image 'txt'", [] { (void)decode_texture("hello", "a.txt"); });
  expect_refusal("unknown kind of image ''", [] { (void)decode_texture("hello", "a"); });
}

TEST(DecodeTexture, RefusesAnImageThatIsCutOff) {
  const std::vector<std::uint8_t> pixels(32 * 32 * 3, 77);
  const std::vector<float> floats(32 * 32 * 3, 0.5F);
  for (const auto& [name, bytes] : {std::pair{"a.png", image_bytes("png", 32, 3, pixels)},
                                    {"a.exr", image_bytes("exr", 32, 3, floats)},
                                    {"a.tif", image_bytes("tif", 32, 3, pixels)},
                                    {"a.jpg", image_bytes("jpg", 32, 3, pixels)}})
    for (const std::size_t kept : {bytes.size() / 8, bytes.size() / 2})
      EXPECT_THROW((void)decode_texture(std::string_view(bytes).substr(0, kept), name), InputError)
          << name << " " << kept;
  // Here the header and its table of rows are whole.
  const std::string exr = image_bytes("exr", 32, 3, floats);
  EXPECT_THROW((void)decode_texture(std::string_view(exr).substr(0, exr.size() - 8), "a.exr"),
               InputError);
}

TEST(DecodeTexture, RefusesAnImageThatIsTooWide) {
  const auto of_width = [](int width) {
    return image_bytes("png", width, 1, std::vector<std::uint8_t>(std::size_t(width)));
  };
  const int most = max_texture_side;
  EXPECT_EQ(decode_texture(of_width(most), "a.png").size(), glm::uvec2(most, 1));
  expect_refusal("an image of 16385 x 1 x 1 pixels, expected 1 to 16384 on a side",
                 [&] { (void)decode_texture(of_width(most + 1), "a.png"); });
}

TEST(DecodeTexture, RefusesAJpegWhoseLastRowsAreMissing) {
  std::vector<std::uint8_t> pixels(64 * 64 * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<std::uint8_t>(i * 7919 >> 3);
  const std::string bytes = image_bytes("jpg", 64, 3, pixels);
  EXPECT_NO_THROW((void)decode_texture(bytes, "a.jpg"));
  for (const std::size_t kept : {bytes.size() / 2, bytes.size() - 20})
    expect_refusal("truncated: no end of image",
                   [&] { (void)decode_texture(std::string_view(bytes).substr(0, kept), "a.jpg"); });
}

// A header that says 16384 x 16384 made 3 GB be asked for. In DWAB, whose 256 lines per chunk need
// few of the bytes that say where chunks are.
TEST(TextureDecoding, refuses_a_size_that_the_bytes_cannot_hold) {
  std::string bytes = test::image_bytes<float>("exr", 2, 3, std::vector<float>(12, 1.0F));
  for (const std::string window : {"dataWindow", "displayWindow"}) {
    const std::size_t at = bytes.find(window) + window.size() + 1 + 6 + 4; // name, "box2i", size
    for (const std::size_t corner : {8, 12}) {
      bytes[at + corner] = '\xff';
      bytes[at + corner + 1] = '\x3f';
    }
  }
  const std::string compression = std::string("compression") + '\0' + "compression" + '\0';
  bytes[bytes.find(compression) + compression.size() + 4] = 9;
  bytes.resize(1584, '\0');
  expect_refusal("truncated: 16384 x 16384 pixels in 1584 bytes",
                 [&] { (void)decode_texture(bytes, "a.exr"); });
}

/// An EXR file of 4 x 4 pixels in one tile of `side` x `side`, half floats, not compressed.
std::string one_tile(std::uint32_t side) {
  const auto word = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += char(value >> (8 * i) & 255);
    return bytes;
  };
  const auto attribute = [&](const std::string& name, const std::string& type,
                             const std::string& value) {
    return name + '\0' + type + '\0' + word(std::uint32_t(value.size())) + value;
  };
  const std::string box = word(0) + word(0) + word(3) + word(3), zero = word(0);
  std::string channels;
  for (const char name : {'B', 'G', 'R'})
    channels += std::string(1, name) + '\0' + word(1) + zero + word(1) + word(1);
  std::string file =
      word(20000630) + word(0x202) + attribute("channels", "chlist", channels + '\0') +
      attribute("compression", "compression", std::string(1, '\0')) +
      attribute("dataWindow", "box2i", box) + attribute("displayWindow", "box2i", box) +
      attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
      attribute("pixelAspectRatio", "float", word(0x3f800000)) +
      attribute("screenWindowCenter", "v2f", zero + zero) +
      attribute("screenWindowWidth", "float", word(0x3f800000)) +
      attribute("tiles", "tiledesc", word(side) + word(side) + '\0') + '\0';
  constexpr std::uint32_t bytes = 4 * 4 * 3 * 2;
  file += word(std::uint32_t(file.size()) + 8) + zero; // where the tile begins
  return file + zero + zero + zero + zero + word(bytes) + std::string(bytes, '\0');
}

TEST(DecodeTexture, RefusesAFewPixelsInAHugeTileBeforeItAsksForTheMemory) {
  EXPECT_EQ(decode_texture(one_tile(4), "a.exr").size(), glm::uvec2(4));
  EXPECT_EQ(decode_texture(one_tile(64), "a.exr").size(), glm::uvec2(4));
  expect_refusal("truncated: 4 x 4 pixels", [] { (void)decode_texture(one_tile(16384), "a.exr"); });
}

} // namespace
} // namespace lightcuts
