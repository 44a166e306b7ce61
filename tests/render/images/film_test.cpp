// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/film.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

// Every bit pattern is as likely: NaNs with payloads, infinities, subnormals.
Film random_film(std::uint32_t seed) {
  std::mt19937 random(seed);
  Film film({17, 11});
  for (const char* name : {"R", "G", "B", "reference.R", "cut.size", "cut.bound", "time.us", "A"})
    for (float& value : film.channel(name))
      value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  film.channel("cut.size")[0] = nan;
  film.channel("cut.size")[1] = inf;
  film.channel("cut.size")[2] = -inf;
  film.channel("cut.size")[3] = -0.0F;
  film.metadata = {{"scene", "box"}, {"seed", "42"}, {"threshold", "0.02"}, {"version", "0.1.0"}};
  return film;
}

std::vector<unsigned char> png_pixels(const std::filesystem::path& file) {
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) return {};
  std::vector<unsigned char> pixels(input->spec().image_pixels() * 3);
  input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data());
  return pixels;
}

TEST(Film, adds_channels_filled_with_zero_in_order) {
  Film film({3, 2});
  const auto b = film.channel("B");
  for (const float value : b) EXPECT_EQ(value, 0);
  b[5] = 7;
  for (int i = 0; i < 100; ++i) static_cast<void>(film.channel(std::to_string(i)));
  EXPECT_EQ(film.channel("B").data(), b.data());
  EXPECT_EQ(std::as_const(film).channel("B")[5], 7);
  EXPECT_EQ(film.channel_names()[1], "0");
  EXPECT_TRUE(std::as_const(film).channel("none").empty());
  EXPECT_EQ(film.channel_names().size(), 101U);
}

TEST(Exr, returns_every_bit_of_every_channel_and_the_metadata) {
  const TemporaryFolder home;
  const Film film = random_film(1);
  write_exr(film, home.path / "film.exr");
  const Film read = read_exr(home.path / "film.exr");
  EXPECT_EQ(read.size(), film.size());
  EXPECT_EQ(read.metadata, film.metadata);
  EXPECT_EQ(read.channel_names().size(), film.channel_names().size());
  for (const std::string& name : film.channel_names()) {
    const auto a = film.channel(name), b = read.channel(name);
    ASSERT_EQ(a.size(), b.size()) << name;
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i]))
          << name << " " << i;
  }
}

TEST(Exr, is_the_same_file_for_the_same_film) {
  const TemporaryFolder home;
  write_exr(random_film(2), home.path / "a.exr");
  write_exr(random_film(2), home.path / "b.exr");
  EXPECT_EQ(content_of(home.path / "a.exr"), content_of(home.path / "b.exr"));
  const auto input = OIIO::ImageInput::open((home.path / "a.exr").string());
  EXPECT_EQ(input->spec().get_string_attribute("DateTime"), "");
  EXPECT_EQ(input->spec().get_string_attribute("lightcuts.seed"), "42");
}

TEST(Exr, names_the_file_it_cannot_read_or_write) {
  const TemporaryFolder home;
  write(home.path / "bad.exr", "not an image");
  const auto message = [](auto action) -> std::string {
    try {
      action();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string unwritable =
      message([&] { write_exr(random_film(1), home.path / "bad.exr/film.exr"); });
  EXPECT_NE(unwritable.find("film.exr"), std::string::npos) << unwritable;
  EXPECT_NE(message([&] { static_cast<void>(read_exr(home.path / "bad.exr")); }).find("bad.exr"),
            std::string::npos);
  EXPECT_THROW(static_cast<void>(read_exr(home.path / "none.exr")), InputError);
  write_exr(random_film(1), home.path / "whole.exr");
  const std::string whole = content_of(home.path / "whole.exr");
  write(home.path / "cut.exr", whole.substr(0, whole.size() - 8));
  EXPECT_NE(message([&] { static_cast<void>(read_exr(home.path / "cut.exr")); }).find("cut.exr"),
            std::string::npos);
  EXPECT_THROW(write_exr(Film({2, 2}), home.path / "empty.exr"), InputError);
  EXPECT_THROW(write_png(home.path / "bad.exr/a.png", {1, 1}, std::vector{glm::vec3(0)}, 1),
               InputError);
}

TEST(Png, exposes_clamps_and_encodes) {
  const TemporaryFolder home;
  const std::vector<glm::vec3> pixels{
      {0, 0.107F, 0.5F}, {inf, -1, 2}, {nan, 0, 0}, {0.25F, 0.25F, 0.25F}};
  write_png(home.path / "a.png", {2, 2}, pixels, 2);
  // sRGB: 0.214 -> 127, 0.5 -> 188.
  EXPECT_EQ(png_pixels(home.path / "a.png"),
            (std::vector<unsigned char>{0, 127, 255, 255, 0, 255, 255, 0, 255, 188, 188, 188}));
}

TEST(AutomaticExposure, maps_the_95th_percentile_to_nine_tenths) {
  std::vector<glm::vec3> pixels;
  for (int i = 1; i <= 101; ++i) pixels.emplace_back(static_cast<float>(i));
  EXPECT_NEAR(automatic_exposure(pixels), 0.9 / 96, 1e-6); // 95 of 100 steps
}

TEST(AutomaticExposure, is_not_moved_by_black_or_broken_pixels) {
  std::vector<glm::vec3> pixels(1000, glm::vec3(0.5F));
  const float plain = automatic_exposure(pixels);
  EXPECT_NEAR(plain, 1.8, 1e-6);
  for (int i = 0; i < 20; ++i) pixels[i] = glm::vec3(1e30F);
  pixels.insert(pixels.end(), 5000, glm::vec3(0));
  pixels.insert(pixels.end(), 500, glm::vec3(nan, 1, 1));
  pixels.insert(pixels.end(), 500, glm::vec3(1, inf, 1));
  EXPECT_EQ(automatic_exposure(pixels), plain);
}

TEST(AutomaticExposure, is_always_finite_and_positive) {
  EXPECT_EQ(automatic_exposure({}), 1);
  EXPECT_EQ(automatic_exposure(std::vector(3, glm::vec3(0))), 1);
  EXPECT_EQ(automatic_exposure(std::vector(3, glm::vec3(nan))), 1);
  for (const float value : {1e-45F, 1e-38F, 3e38F}) {
    const float exposure = automatic_exposure(std::vector(3, glm::vec3(value)));
    EXPECT_TRUE(std::isfinite(exposure) && exposure > 0) << value;
  }
}

} // namespace
} // namespace lightcuts
