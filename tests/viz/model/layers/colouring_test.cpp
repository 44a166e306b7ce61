// SPDX-License-Identifier: MIT
#include <viz/model/layers/colouring.h>

#include <cmath>

#include <gtest/gtest.h>
#include <lightcuts/render/images/film.h>

#include <tests/support/float_limits.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

LayerValues with_size(std::size_t count) {
  LayerValues layer;
  layer.size = {unsigned(count), 1};
  layer.known.assign(count, 1);
  layer.surface.assign(count, 1);
  return layer;
}
LayerValues heat(std::vector<float> values) {
  LayerValues layer = with_size(values.size());
  layer.values = std::move(values);
  return layer;
}
LayerValues image_layer(std::vector<glm::vec3> radiance) {
  LayerValues layer = with_size(radiance.size());
  layer.image = std::move(radiance);
  return layer;
}

/// Tables have steps.
void expect_near(const Rgb8& a, const Rgb8& b, int most) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(int(a[c]), int(b[c]), most) << "channel " << c;
}

TEST(Coloured, ShowsAnImageInSrgbTimesItsExposure) {
  std::vector<glm::vec3> radiance;
  for (int i = 0; i < 1000; ++i)
    radiance.emplace_back(float(i) / 500, float(i % 10) / 2000, std::pow(2.0F, -float(i) / 50));
  ColourSettings settings;
  settings.exposure = 0.75F;
  const Coloured shown = coloured(layers::image, image_layer(radiance), settings);
  EXPECT_EQ(shown.exposure, 0.75F);
  EXPECT_EQ(shown.size, glm::uvec2(1000, 1));
  for (std::size_t i = 0; i < radiance.size(); ++i)
    expect_near(shown.pixels[i], srgb8(0.75F * radiance[i]), 1);
}

TEST(Coloured, ExposesAnImageAsChosenOrAsAskedForOrByItself) {
  LayerValues layer = image_layer({{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {400, 400, 400}});
  layer.known[3] = 0;
  const std::vector<glm::vec3> known{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  ColourSettings settings;
  EXPECT_EQ(coloured(layers::image, layer, settings).exposure, automatic_exposure(known));
  EXPECT_EQ(coloured(layers::image, layer, settings, 5.0F).exposure, 5);
  settings.exposure = 2;
  EXPECT_EQ(coloured(layers::image, layer, settings, 5.0F).exposure, 2);
}

TEST(Coloured, ShowsValuesInTheColoursOfTheMap) {
  std::vector<float> values;
  for (int i = 0; i <= 300; ++i) values.push_back(float(i) / 3);
  for (const ColourMap map : all_colour_maps) {
    ColourSettings settings;
    settings.map = map;
    const Coloured shown = coloured(layers::cut_size, heat(values), settings);
    EXPECT_EQ(shown.scale.lo, 0);
    EXPECT_EQ(shown.scale.hi, 100);
    for (std::size_t i = 0; i < values.size(); ++i)
      expect_near(shown.pixels[i], heat_colour(values[i], shown.scale, map), 4);
    EXPECT_EQ(shown.pixels.front(), heat_colour(0, shown.scale, map));
    EXPECT_EQ(shown.pixels.back(), heat_colour(100, shown.scale, map));
  }
}

TEST(Coloured, ShowsLogarithmsWhereAsked) {
  ColourSettings settings;
  settings.logarithmic = true;
  const Coloured shown = coloured(layers::error, heat({0.01F, 0.1F, 1, 0}), settings);
  const HeatMapScale scale{0.01F, 1, true};
  expect_near(shown.pixels[1], heat_colour(0.1F, scale), 4);
  EXPECT_EQ(shown.pixels[3], shown.pixels[0]) << "0 is below the scale";
}

TEST(Coloured, HasColoursOfTheirOwnForWhatIsNoNumber) {
  const Coloured shown = coloured(layers::error, heat({nan, inf, -inf, 1}), {});
  EXPECT_EQ(shown.pixels[0], nan_colour);
  EXPECT_EQ(shown.pixels[1], infinity_colour);
  EXPECT_EQ(shown.pixels[2], negative_infinity_colour);
  EXPECT_EQ(shown.statistics.nan, 1U);
  const Coloured picture = coloured(layers::image, image_layer({{1, nan, inf}, {inf, 0, 0}}), {});
  EXPECT_EQ(picture.pixels[0], nan_colour);
  EXPECT_EQ(picture.pixels[1], infinity_colour);
}

TEST(Coloured, TellsWhatIsNotKnownFromWhatSeesNothing) {
  LayerValues layer = heat({1, 2, 3});
  layer.known[0] = 0;
  layer.surface[1] = 0;
  const Coloured shown = coloured(layers::error, layer, {});
  EXPECT_EQ(shown.pixels[0], pending_colour);
  EXPECT_EQ(shown.pixels[1], nothing_colour);
  EXPECT_EQ(shown.pixels[2], heat_colour(3, {0, 3, false}));
  LayerValues picture = image_layer({{1, 1, 1}, {0, 0, 0}});
  picture.known[0] = 0;
  picture.surface[1] = 0;
  const Coloured seen = coloured(layers::image, picture, {});
  EXPECT_EQ(seen.pixels[0], pending_colour);
  EXPECT_EQ(seen.pixels[1], Rgb8(0)) << "an image shows what there is";
}

TEST(ScaleOf, IsTheChosenRange) {
  ColourSettings settings;
  settings.automatic_range = false;
  settings.lo = -2;
  settings.hi = 5;
  LayerStatistics statistics;
  statistics.largest = 100;
  HeatMapScale scale = scale_of(settings, statistics);
  EXPECT_EQ(scale.lo, -2);
  EXPECT_EQ(scale.hi, 5);
  settings.logarithmic = true;
  EXPECT_FALSE(scale_of(settings, statistics).logarithmic) << "from below 0";
  settings.lo = 0.5F;
  EXPECT_TRUE(scale_of(settings, statistics).logarithmic);
  settings.automatic_range = true;
  settings.logarithmic = false;
  EXPECT_EQ(scale_of(settings, statistics).hi, 100);
}

} // namespace
} // namespace lightcuts::viz
