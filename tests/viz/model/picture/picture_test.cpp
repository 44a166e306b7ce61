// SPDX-License-Identifier: MIT
#include <viz/model/picture/picture.h>

#include <algorithm>
#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/viz/support/made_up_picture.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::Each;

constexpr glm::uvec2 odd_size{37, 21};

/// Of a pass: the first whose grid has the pixel.
int pass_of(glm::uvec2 pixel) {
  int pass = 0;
  for (const unsigned step : {16U, 4U, 1U}) {
    if (pixel.x % step == 0 && pixel.y % step == 0) break;
    ++pass;
  }
  return pass;
}

/// Goes on until so many more pixels have been made.
void advance_by(MadeUpPicture& picture, std::size_t pixels) {
  const std::size_t end = picture.order.size() + pixels;
  picture.advance(Progress::until([&] { return picture.order.size() >= end; }));
}

/// The nearest pixel to the upper left, itself included, that lies on the finest grid with it made.
std::uint32_t expected_source(const MadeUpPicture& picture, glm::uvec2 pixel) {
  for (const unsigned step : {1U, 4U, 16U}) {
    const unsigned x = pixel.x / step * step, y = pixel.y / step * step;
    const std::uint32_t i = y * picture.size().x + x;
    if (picture.times[i] > 0) return i;
  }
  return Picture::unknown;
}

TEST(Picture, MakesEveryPixelOnceCoarseFirst) {
  for (const glm::uvec2 size :
       {odd_size, glm::uvec2(1, 1), glm::uvec2(16, 16), glm::uvec2(3, 50)}) {
    MadeUpPicture picture(size);
    EXPECT_FALSE(picture.complete());
    picture.advance();
    EXPECT_TRUE(picture.complete());
    EXPECT_EQ(picture.share(), 1);
    EXPECT_THAT(picture.times, Each(1));
    EXPECT_TRUE(std::is_sorted(picture.order.begin(), picture.order.end(),
                               [](auto a, auto b) { return pass_of(a) < pass_of(b); }));
    EXPECT_EQ(picture.failure(), "");
  }
}

TEST(Picture, GoesOnWhereItWasCancelled) {
  for (const std::size_t piece : {1U, 5U, 64U, 300U}) {
    MadeUpPicture picture(odd_size);
    for (std::size_t made = 0; made < picture.pixel_count(); made += piece) {
      EXPECT_FALSE(picture.complete());
      EXPECT_EQ(picture.order.size(), made);
      EXPECT_DOUBLE_EQ(picture.share(), double(made) / double(picture.pixel_count()));
      advance_by(picture, piece);
    }
    EXPECT_TRUE(picture.complete());
    EXPECT_THAT(picture.times, Each(1));
  }
}

TEST(Picture, DoesNothingWhereItIsCancelledAtOnce) {
  MadeUpPicture picture(odd_size);
  picture.advance(Progress::until([] { return true; }));
  EXPECT_EQ(picture.calls, 0);
  EXPECT_EQ(picture.share(), 0);
  EXPECT_THAT(picture.sources(), Each(Picture::unknown));
  EXPECT_FALSE(picture.seconds_left());
}

TEST(Picture, ShowsTheNearestKnownPixelInPlaceOfAnUnknownOne) {
  MadeUpPicture picture(odd_size);
  while (!picture.complete()) {
    advance_by(picture, 17);
    const std::vector<std::uint32_t> sources = picture.sources();
    for (unsigned y = 0; y < odd_size.y; ++y)
      for (unsigned x = 0; x < odd_size.x; ++x) {
        const std::uint32_t expected = expected_source(picture, {x, y});
        ASSERT_EQ(sources[y * odd_size.x + x], expected) << x << ", " << y;
        ASSERT_EQ(picture.source_of({x, y}), expected) << x << ", " << y;
      }
  }
}

TEST(Picture, GrowsItsVersionWithEveryPixel) {
  MadeUpPicture picture(odd_size);
  while (!picture.complete()) {
    const std::uint64_t before = picture.version();
    advance_by(picture, 1);
    EXPECT_GT(picture.version(), before);
  }
}

TEST(Picture, KeepsTheMessageOfWhatFails) {
  MadeUpPicture picture(odd_size);
  picture.before_pixel = [&] {
    if (picture.order.size() == 7) throw std::runtime_error("out of luck");
  };
  const std::uint64_t before = picture.version();
  picture.advance();
  EXPECT_EQ(picture.failure(), "out of luck");
  EXPECT_TRUE(picture.complete()) << "nothing more will come";
  EXPECT_DOUBLE_EQ(picture.share(), 7.0 / double(picture.pixel_count()));
  EXPECT_GT(picture.version(), before + 7) << "the window is to see the failure";
}

TEST(Picture, MayBeLookedAtWhileItIsMade) {
  MadeUpPicture picture({64, 48});
  picture.before_pixel = [] { std::this_thread::yield(); };
  std::thread maker([&] { picture.advance(); });
  double share = 0;
  std::uint64_t version = 0;
  bool complete = false;
  while (!complete) {
    std::this_thread::sleep_for(std::chrono::microseconds(100)); // let the maker have its turn
    complete = picture.complete();
    EXPECT_GE(picture.share(), share);
    EXPECT_GE(picture.version(), version);
    share = picture.share();
    version = picture.version();
    for (const std::uint32_t i : picture.sources())
      if (i != Picture::unknown) {
        ASSERT_EQ(picture.values[i], i + 1) << "known before it was made";
      }
  }
  maker.join();
  EXPECT_EQ(share, 1);
}

TEST(Picture, KnowsHowLongItHasTakenWhileItIsMade) {
  MadeUpPicture picture({8, 8});
  double before = -1;
  picture.before_pixel = [&] {
    const double seconds = picture.seconds();
    EXPECT_GT(seconds, before);
    before = seconds;
    if (picture.order.size() == 32) {
      EXPECT_GE(seconds, 0.032);
      // As long as it took so far.
      const double left = picture.seconds_left().value_or(-1);
      EXPECT_GE(left, seconds);
      EXPECT_LE(left, picture.seconds());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  picture.advance();
  EXPECT_GE(picture.seconds(), 0.064);
  EXPECT_EQ(picture.seconds_left(), 0);
}

TEST(Picture, AddsUpTheTimesBetweenWhichItWasCancelled) {
  MadeUpPicture picture({8, 8});
  picture.before_pixel = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  advance_by(picture, 32);
  const double half = picture.seconds();
  EXPECT_GE(half, 0.032);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(picture.seconds(), half) << "nobody works on it";
  picture.advance();
  EXPECT_GE(picture.seconds(), half + 0.032);
}

} // namespace
} // namespace lightcuts::viz
