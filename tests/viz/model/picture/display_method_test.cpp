// SPDX-License-Identifier: MIT
#include <viz/model/picture/display_method.h>

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace lightcuts::viz {
namespace {

TEST(DisplayMethod, IsEachOfTheLibrarysOrThePreview) {
  EXPECT_EQ(std::size(all_displays), std::size(all_methods) + 1);
  EXPECT_TRUE(DisplayMethod::raster().is_raster());
  EXPECT_EQ(DisplayMethod::raster().method(), methods::lightcuts);
  EXPECT_NE(DisplayMethod::raster(), DisplayMethod(methods::lightcuts));
  for (const Method method : all_methods) {
    const DisplayMethod display = method;
    EXPECT_FALSE(display.is_raster());
    EXPECT_EQ(display.method(), method);
    EXPECT_NE(std::find(std::begin(all_displays), std::end(all_displays), display),
              std::end(all_displays));
    EXPECT_STREQ(name_of(display), method->name);
  }
}

TEST(DisplayMethod, IsFoundByItsNameAndSaysWhatItIs) {
  std::set<std::string> meanings;
  for (const DisplayMethod& display : all_displays) {
    EXPECT_EQ(value_named<DisplayMethod>(name_of(display)), display);
    meanings.insert(meaning_of(display));
    EXPECT_EQ(std::string(meaning_of(display)).back(), '.');
  }
  EXPECT_EQ(meanings.size(), std::size(all_displays));
  for (const char* name : {"", "Raster", "light", "lightcuts "})
    EXPECT_FALSE(value_named<DisplayMethod>(name)) << name;
}

TEST(DisplayMethod, GoesRoundInBothDirections) {
  for (const int direction : {1, -1}) {
    DisplayMethod display = methods::lightcuts;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < std::size(all_displays); ++i) {
      seen.insert(name_of(display));
      EXPECT_EQ(next(next(display, direction), -direction), display);
      display = next(display, direction);
    }
    EXPECT_EQ(display, DisplayMethod(methods::lightcuts));
    EXPECT_EQ(seen.size(), std::size(all_displays));
  }
  EXPECT_EQ(next(DisplayMethod::raster(), 1), DisplayMethod(methods::reference));
}

} // namespace
} // namespace lightcuts::viz
