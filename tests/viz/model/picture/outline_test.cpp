// SPDX-License-Identifier: MIT
#include <viz/model/picture/outline.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightcuts::viz {

namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(Outline, GoesAroundAPixel) {
  const glm::uvec2 pixels[] = {{3, 5}};
  EXPECT_THAT(outline_of(pixels),
              UnorderedElementsAre(PixelEdge{{3, 5}, {4, 5}}, PixelEdge{{4, 5}, {4, 6}},
                                   PixelEdge{{3, 6}, {4, 6}}, PixelEdge{{3, 5}, {3, 6}}));
}

TEST(Outline, HasNoEdgeBetweenItsPixels) {
  const glm::uvec2 pixels[] = {{0, 0}, {1, 0}, {0, 1}};
  EXPECT_THAT(outline_of(pixels),
              UnorderedElementsAre(PixelEdge{{0, 0}, {1, 0}}, PixelEdge{{1, 0}, {2, 0}},
                                   PixelEdge{{2, 0}, {2, 1}}, PixelEdge{{1, 1}, {2, 1}},
                                   PixelEdge{{1, 1}, {1, 2}}, PixelEdge{{0, 2}, {1, 2}},
                                   PixelEdge{{0, 0}, {0, 1}}, PixelEdge{{0, 1}, {0, 2}}));
}

TEST(Outline, OfNothingIsNothing) { EXPECT_THAT(outline_of({}), IsEmpty()); }

} // namespace
} // namespace lightcuts::viz
