// SPDX-License-Identifier: MIT
#include <oracle/report/image_error.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

/// Four pixels, of which the last sees no surface.
Rendering rendering(const std::vector<glm::vec3>& radiance) {
  Rendering r;
  r.size = {4, 1};
  r.radiance = radiance;
  r.certified_error.assign(4, glm::vec3(0));
  r.cut_size = {5, 5, 5, 0};
  r.surface_pixels = 3;
  return r;
}

const Rendering reference_picture = rendering({{1, 1, 2}, {0, 0, 0}, {2, 2, 4}, {0, 0, 0}});

Rendering picture() {
  // Off by 1 of 4, by 0 of 0, by 0.25 of 8.
  Rendering r = rendering({{1.5F, 1, 1.5F}, {0, 0, 0}, {2, 2.25F, 4}, {9, 9, 9}});
  r.certified_error = {{1, 1, 1}, {0, 0, 0}, {2, 0, 0}, {7, 7, 7}};
  return r;
}

TEST(ImageError, IsZeroForTheReferenceItself) {
  const ImageError e = compare(reference_picture, reference_picture, 0, 0);
  EXPECT_EQ(e.mean, 0);
  EXPECT_EQ(e.max, 0);
  EXPECT_EQ(e.rel_rmse, 0);
  EXPECT_EQ(e.mrse, 0);
  EXPECT_EQ(e.mean_certified, 0);
  EXPECT_EQ(e.pixels_over_threshold, 0U);
}

TEST(ImageError, IsThatWorkedOutByHand) {
  const ImageError e = compare(picture(), reference_picture, 0.1, 0);
  EXPECT_DOUBLE_EQ(e.mean, (0.25 + 0 + 0.03125) / 3);
  EXPECT_DOUBLE_EQ(e.max, 0.25);
  EXPECT_DOUBLE_EQ(e.mean_certified, (0.75 + 0 + 0.25) / 3);
  EXPECT_EQ(e.pixels_over_threshold, 1U);
  // Squares 1/4, 1/4 and 1/16 over nine channels, whose references sum to 12.
  EXPECT_DOUBLE_EQ(e.rel_rmse, std::sqrt(0.5625 / 9) / (12.0 / 9));
  EXPECT_DOUBLE_EQ(e.mrse,
                   (0.25 / (1.01 * 1.01) + 0.25 / (2.01 * 2.01) + 0.0625 / (2.01 * 2.01)) / 9);
}

TEST(ImageError, CountsPixelsOverTheThresholdOnly) {
  EXPECT_EQ(compare(picture(), reference_picture, 0.25, 0).pixels_over_threshold, 0U);
  EXPECT_EQ(compare(picture(), reference_picture, 0.03125, 0).pixels_over_threshold, 1U);
  EXPECT_EQ(compare(picture(), reference_picture, 0.03, 0).pixels_over_threshold, 2U);
  EXPECT_EQ(compare(picture(), reference_picture, 0, 0).pixels_over_threshold, 2U);
}

// The first pixel's 1 is relative to 3 * 2 instead of 4, the third's 0.25 still to 8.
TEST(ImageError, IsRelativeToTheBlackLevelAtLeast) {
  const ImageError e = compare(picture(), reference_picture, 0.1, 2);
  EXPECT_DOUBLE_EQ(e.mean, (1.0 / 6 + 0 + 0.03125) / 3);
  EXPECT_DOUBLE_EQ(e.mean_certified, (0.5 + 0 + 0.25) / 3);
}

TEST(ImageError, OfLightWhereThereShouldBeNoneIsInfinite) {
  const Rendering wrong = rendering({{1, 1, 2}, {1, 0, 0}, {2, 2, 4}, {0, 0, 0}});
  EXPECT_EQ(compare(wrong, reference_picture, 0.1, 0).max, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(compare(wrong, reference_picture, 0.1, 0.5).max, 1 / 1.5);
}

TEST(ImageError, OfAnEmptyPictureIsZero) {
  Rendering nothing = rendering(std::vector<glm::vec3>(4, glm::vec3(0)));
  nothing.cut_size.assign(4, 0);
  nothing.surface_pixels = 0;
  const ImageError e = compare(nothing, nothing, 0, 0);
  EXPECT_EQ(e.mean, 0);
  EXPECT_EQ(e.rel_rmse, 0);
}

TEST(ImageError, OfABlackReferenceHasNoNan) {
  const Rendering black = rendering(std::vector<glm::vec3>(4, glm::vec3(0)));
  const ImageError e = compare(picture(), black, 0.1, 0.5);
  EXPECT_EQ(e.rel_rmse, 0);
  EXPECT_TRUE(std::isfinite(e.mean));
}

TEST(RelativeErrors, AreThoseOfEachPixel) {
  Rendering p = picture();
  p.radiance[3] = glm::vec3(0); // as render() leaves it
  EXPECT_EQ(relative_errors(p, reference_picture, 0), (std::vector<float>{0.25F, 0, 0.03125F, 0}));
}

TEST(ImageError, OfTwoSaturatedPixelsIsZeroAndOfOneInfinite) {
  const Rendering saturated = rendering({{inf, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}});
  const Rendering one = rendering({{5, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}});
  const ImageError same = compare(saturated, saturated, 0.1, 0);
  EXPECT_EQ(same.mean, 0);
  EXPECT_EQ(same.rel_rmse, 0);
  EXPECT_EQ(compare(one, saturated, 0.1, 0).max, std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare(one, saturated, 0.1, 0).rel_rmse, 0);
}

} // namespace
} // namespace lightcuts::oracle
