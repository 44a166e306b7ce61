// SPDX-License-Identifier: MIT
#include <viz/model/picture/image_view.h>

#include <gtest/gtest.h>

namespace lightcuts::viz {
namespace {

constexpr ScreenArea screen_area{{100, 50}, {800, 600}};
constexpr glm::uvec2 image_size{320, 200};

void expect_near(const glm::dvec2& a, const glm::dvec2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(ImageView, FitsTheWholeImageInTheMiddleOfTheArea) {
  const ImageView view = settled({}, screen_area, image_size);
  EXPECT_EQ(view.zoom, 2.5) << "800 / 320, less than 600 / 200";
  expect_near(to_screen(view, screen_area, {0, 0}), {100, 100});
  expect_near(to_screen(view, screen_area, {320, 200}), {900, 600});
  EXPECT_TRUE(view.fits);
  EXPECT_EQ(settled(view, screen_area, {80, 600}).zoom, 1) << "as high as the area";
}

TEST(ImageView, StaysAsItIsUnlessItFits) {
  const ImageView view{3, {10, 20}, false};
  EXPECT_EQ(settled(view, screen_area, image_size), view);
}

TEST(ImageView, FitsWithinTheLimitsOfZoom) {
  EXPECT_EQ(settled({}, screen_area, {1, 1}).zoom, max_zoom);
  EXPECT_EQ(settled({}, {{0, 0}, {4, 4}}, {16384, 16384}).zoom, min_zoom);
  EXPECT_EQ(settled({}, {{0, 0}, {0, 0}}, image_size).zoom, min_zoom);
}

TEST(ImageView, GoesToTheScreenAndBack) {
  const ImageView view{7, {31, 12.5}, false};
  for (const glm::dvec2 at : {glm::dvec2(0, 0), {31, 12.5}, {-5, 400}, {319.9, 0.1}})
    expect_near(to_image(view, screen_area, to_screen(view, screen_area, at)), at);
  expect_near(to_screen(view, screen_area, {31, 12.5}), {500, 350}); // the middle of the area
  expect_near(to_screen(view, screen_area, {32, 12.5}), {507, 350});
}

TEST(ImageView, FindsThePixelUnderTheCursor) {
  const ImageView view = settled({}, screen_area, image_size);
  EXPECT_EQ(pixel_at(view, screen_area, {100, 100}, image_size), glm::uvec2(0, 0));
  EXPECT_EQ(pixel_at(view, screen_area, {102.4, 102.6}, image_size), glm::uvec2(0, 1));
  EXPECT_EQ(pixel_at(view, screen_area, {899.9, 599.9}, image_size), glm::uvec2(319, 199));
  for (const glm::dvec2 outside : {glm::dvec2(99.9, 300), {900, 300}, {500, 99.9}, {500, 600}})
    EXPECT_FALSE(pixel_at(view, screen_area, outside, image_size))
        << outside.x << ", " << outside.y;
}

TEST(ImageView, ZoomsAboutTheCursor) {
  const glm::dvec2 cursor{640, 110};
  for (const double factor : {2.0, 0.3, 1.1, 1e6, 1e-6}) {
    const ImageView before = settled({}, screen_area, image_size);
    const ImageView after = zoomed(before, screen_area, cursor, factor);
    EXPECT_FALSE(after.fits);
    expect_near(to_image(after, screen_area, cursor), to_image(before, screen_area, cursor));
    EXPECT_GE(after.zoom, min_zoom);
    EXPECT_LE(after.zoom, max_zoom);
  }
  EXPECT_EQ(zoomed({4, {0, 0}, false}, screen_area, cursor, 2).zoom, 8);
}

TEST(ImageView, MovesWithTheMouse) {
  const ImageView before{4, {10, 20}, false};
  const ImageView after = panned(before, {12, -6});
  for (const glm::dvec2 at : {glm::dvec2(0, 0), {5, 7}})
    expect_near(to_screen(after, screen_area, at),
                to_screen(before, screen_area, at) + glm::dvec2(12, -6));
  EXPECT_FALSE(panned(settled({}, screen_area, image_size), {1, 1}).fits);
}

TEST(ImageView, ShowsOnePixelForOneAboutTheMiddle) {
  const ImageView view = one_to_one(settled({}, screen_area, image_size));
  EXPECT_EQ(view.zoom, 1);
  EXPECT_FALSE(view.fits);
  expect_near(to_image(view, screen_area, {500, 350}), {160, 100});
}

} // namespace
} // namespace lightcuts::viz
