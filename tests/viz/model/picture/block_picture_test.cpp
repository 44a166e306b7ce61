// SPDX-License-Identifier: MIT
#include <viz/model/picture/block_picture.h>

#include <gtest/gtest.h>

#include <tests/viz/support/small_pictures.h>
#include <viz/model/layers/all_layers.h>
#include <viz/model/layers/layer_values.h>
#include <viz/model/picture/lit_square.h>

namespace lightcuts::viz {
namespace {

TEST(BlockPicture, HasOfEachPixelWhatItsSquareSays) {
  const FrameKey key = small_key(methods::block_cuts);
  const auto picture = made<BlockPicture>(key);
  ASSERT_TRUE(picture->complete());
  const auto frame = std::make_shared<Frame>(key);
  const LayerSources sources{frame, nullptr, nullptr, picture};
  for (const glm::uvec2 pixel : some_pixels) {
    const LitSquare lit(key.scene->view(), *key.scene->tree(), frame->cut(), 1, pixel);
    const std::size_t p = lit.index_of(pixel);
    EXPECT_EQ(layer_value(layers::block_size, sources, pixel), float(lit.block(p).size()));
    EXPECT_EQ(layer_value(layers::proven, sources, pixel), float(lit.proven(p)));
  }
}

TEST(BlockPicture, SaysThatPixelsStandAloneByMethodsThatShareNothing) {
  const auto picture = made<BlockPicture>(small_key(methods::lightcuts));
  const auto frame = made<Frame>(small_key(methods::lightcuts));
  for (std::size_t i = 0; i < picture->pixel_count(); ++i) {
    EXPECT_EQ(picture->block_size()[i], frame->rendering().cut_size[i] > 0 ? 1 : 0);
    EXPECT_EQ(picture->proven()[i], 0);
  }
}

TEST(BlockPicture, IsKnownSquareBySquareAndGoesOnWhereItWasCancelled) {
  const FrameKey key = small_key(methods::block_cuts);
  const auto picture = std::make_shared<BlockPicture>(key);
  picture->advance(Progress::until([&] { return picture->share() > 0; }));
  EXPECT_LT(picture->share(), 1);
  const auto known =
      layer_values(layers::block_size, {std::make_shared<Frame>(key), {}, {}, picture});
  std::size_t own = 0;
  for (const char c : known.own) own += c != 0 ? 1 : 0;
  EXPECT_GT(own, 0U);
  EXPECT_EQ(own % (std::size_t(PixelSquare::side) * PixelSquare::side), 0U);
  picture->advance();
  EXPECT_TRUE(picture->complete());
  EXPECT_EQ(picture->block_size(), made<BlockPicture>(key)->block_size());
  EXPECT_EQ(picture->proven(), made<BlockPicture>(key)->proven());
}

} // namespace
} // namespace lightcuts::viz
