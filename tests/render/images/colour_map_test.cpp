// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/colour_map.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <tests/render/support/temporary_folder.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb8> pixels;
  Rgb8 at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

Picture read_png(const std::filesystem::path& file) {
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) return {};
  Picture picture{input->spec().width, input->spec().height, {}};
  picture.pixels.resize(input->spec().image_pixels());
  input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.pixels.data());
  return picture;
}

int brightness(const Rgb8& c) { return 2 * c.r + 7 * c.g + c.b; }

TEST(HeatColour, differs_from_map_to_map) {
  std::set<std::string> names;
  std::set<std::array<int, 3>> colours;
  for (const ColourMap map : all_colour_maps) {
    names.insert(name_of(map));
    const Rgb8 c = heat_colour(0.6F, {}, map);
    colours.insert({c.r, c.g, c.b});
    EXPECT_EQ(heat_colour(nan, {}, map), nan_colour);
  }
  EXPECT_EQ(names.size(), std::size(all_colour_maps));
  EXPECT_EQ(colours.size(), std::size(all_colour_maps));
  EXPECT_EQ(heat_colour(0.6F, {}), heat_colour(0.6F, {}, ColourMap::inferno));
}

TEST(Srgb8, encodes_and_clamps) {
  EXPECT_EQ(srgb8(glm::vec3(0, 0.5F, 1)), Rgb8(0, 188, 255));
  EXPECT_EQ(srgb8({-inf, nan, inf}), Rgb8(0, 0, 255));
  EXPECT_EQ(srgb8({0.0031308F, 1e-45F, 0.214F}), Rgb8(10, 0, 127));
}

TEST(HeatMapScale, maps_lo_to_0_and_hi_to_1) {
  EXPECT_EQ(fraction_of(2, {2, 10, false}), 0);
  EXPECT_EQ(fraction_of(6, {2, 10, false}), 0.5F);
  EXPECT_EQ(fraction_of(10, {2, 10, false}), 1);
  EXPECT_FLOAT_EQ(fraction_of(10, {1, 1000, true}), 1.0F / 3);
  EXPECT_FLOAT_EQ(value_at(0.5F, {1, 10000, true}), 100);
  EXPECT_EQ(fraction_of(0, {1, 1000, true}), 0);
  EXPECT_EQ(fraction_of(-1, {0, 1, false}), 0);
  EXPECT_EQ(fraction_of(2, {0, 1, false}), 1);
}

TEST(HeatMapScale, survives_the_ends_of_float) {
  EXPECT_FLOAT_EQ(fraction_of(0, {-3e38F, 3e38F, false}), 0.5F);
  EXPECT_FLOAT_EQ(fraction_of(1, {1e-38F, 1e38F, true}), 0.5F);
  EXPECT_EQ(fraction_of(5, {5, 5, true}), 0);
  EXPECT_EQ(fraction_of(6, {5, 5, true}), 1);
  EXPECT_EQ(value_at(1, {5, 5, false}), 5);
}

TEST(HeatColour, grows_brighter_with_the_value) {
  // In steps of 8: neighbours may swap places by rounding to 8 bits.
  for (int i = 8; i <= 255; ++i)
    EXPECT_GT(brightness(heat_colour(static_cast<float>(i) / 255, {})),
              brightness(heat_colour(static_cast<float>(i - 8) / 255, {})))
        << i;
  EXPECT_LT(brightness(heat_colour(0, {})), 100);
  EXPECT_GT(brightness(heat_colour(1, {})), 2200);
}

TEST(HeatColour, is_sRGB) {
  // The middle of matplotlib's inferno is (0.736, 0.216, 0.330) in sRGB.
  const Rgb8 middle = heat_colour(0.5F, {});
  EXPECT_NEAR(middle.r, 188, 4);
  EXPECT_NEAR(middle.g, 55, 4);
  EXPECT_NEAR(middle.b, 84, 4);
}

TEST(HeatColour, marks_what_is_not_a_number) {
  EXPECT_EQ(heat_colour(nan, {}), nan_colour);
  EXPECT_EQ(heat_colour(inf, {}), infinity_colour);
  EXPECT_EQ(heat_colour(-inf, {}), negative_infinity_colour);
}

TEST(HeatMap, shows_each_value_and_a_legend_below) {
  const TemporaryFolder home;
  std::vector<float> values(300 * 20);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 300);
  values[300] = nan;
  values[301] = inf;
  const HeatMapScale scale{1, 299, true};
  write_heat_map(home.path / "a.png", {300, 20}, values, scale);
  const Picture picture = read_png(home.path / "a.png");
  ASSERT_EQ(picture.width, 300);
  ASSERT_GT(picture.height, 20);
  EXPECT_EQ(picture.at(150, 3), heat_colour(150, scale));
  EXPECT_EQ(picture.at(0, 1), nan_colour);
  EXPECT_EQ(picture.at(1, 1), infinity_colour);
  EXPECT_EQ(picture.at(6, 30), heat_colour(0, {})); // the bar's ends
  EXPECT_EQ(picture.at(293, 30), heat_colour(1, {}));
  int text = 0;
  for (int y = 38; y < picture.height; ++y)
    for (int x = 0; x < 300; ++x) text += brightness(picture.at(x, y)) > 1500 ? 1 : 0;
  EXPECT_GT(text, 30); // three numbers
}

TEST(HeatMap, is_written_however_small) {
  const TemporaryFolder home;
  for (const unsigned width : {1U, 2U, 13U, 49U, 80U}) {
    write_heat_map(home.path / "a.png", {width, 1}, std::vector<float>(width, 1), {-1e30F, 1e30F});
    EXPECT_EQ(read_png(home.path / "a.png").width, static_cast<int>(width));
  }
}

TEST(HeatMap, refuses_a_scale_that_is_none_and_a_file_that_cannot_be) {
  const std::vector<float> values{1};
  const TemporaryFolder home;
  const auto file = home.path / "a.png";
  for (const HeatMapScale& scale :
       {HeatMapScale{1, 0, false}, {nan, 1, false}, {0, inf, false}, {0, 1, true}})
    EXPECT_THROW(write_heat_map(file, {1, 1}, values, scale), InputError);
  EXPECT_THROW(write_heat_map("/dev/null/a.png", {1, 1}, values, {}), InputError);
}

} // namespace
} // namespace lightcuts
