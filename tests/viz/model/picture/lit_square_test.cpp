// SPDX-License-Identifier: MIT
#include <viz/model/picture/lit_square.h>

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

constexpr unsigned square_side = PixelSquare::side;

std::vector<LitSquare> squares_of(const FrameKey& key) {
  const Frame frame(key);
  std::vector<LitSquare> all;
  for (unsigned y = 0; y < frame.size().y; y += square_side)
    for (unsigned x = 0; x < frame.size().x; x += square_side)
      all.emplace_back(key.scene->view(), *key.scene->tree(), frame.cut(), key.settings.seed,
                       glm::uvec2(x, y));
  return all;
}

/// All squares of the small scene.
const std::vector<LitSquare>& small_squares() {
  static const auto squares = squares_of(small_key(methods::block_cuts));
  return squares;
}

TEST(LitSquare, HasTheBitsOfTheRenderedPixels) {
  const auto frame = made<Frame>(small_key(methods::block_cuts));
  const Rendering& r = frame->rendering();
  std::size_t pixels = 0;
  for (const LitSquare& lit : small_squares())
    for (std::size_t p = 0; p < lit.pixels().size(); ++p, ++pixels) {
      const std::size_t i = std::size_t(lit.pixels()[p].y) * frame->size().x + lit.pixels()[p].x;
      EXPECT_EQ(lit.cut(p).radiance, r.radiance[i]);
      EXPECT_EQ(lit.cut(p).certified_error, r.certified_error[i]);
      EXPECT_EQ(float(lit.cut(p).shadow_rays), r.shadow_rays[i]);
      EXPECT_EQ(float(lit.clusters(p).size()), r.cut_size[i]);
    }
  EXPECT_EQ(pixels, r.surface_pixels);
}

TEST(LitSquare, IsPartedIntoItsBlocks) {
  std::size_t largest = 0, smallest = 1000;
  for (const LitSquare& lit : small_squares())
    for (std::uint32_t p = 0; p < lit.pixels().size(); ++p) {
      EXPECT_EQ(std::ranges::count(lit.block(p), p), 1);
      for (const std::uint32_t other : lit.block(p)) EXPECT_EQ(lit.block(other), lit.block(p));
      largest = std::max(largest, lit.block(p).size());
      smallest = std::min(smallest, lit.block(p).size());
    }
  EXPECT_EQ(largest, std::size_t(square_side) * square_side);
  EXPECT_LT(smallest, largest);
}

TEST(LitSquare, SaysOfNoClusterThatItIsSeenOrHiddenUnlessEachOfItsLightsIs) {
  std::map<Sight, int> count;
  FrameKey key = small_key(methods::block_cuts);
  key.scene = opened("cloud?lights=400&blocks=30", {96, 72}); // much is hidden
  key.camera = key.scene->scene().camera;
  key.settings.threshold = 0.02F;
  for (const LitSquare& lit : squares_of(key))
    for (std::size_t p = 0; p < lit.pixels().size(); p += 5) {
      const VisiblePoint at = *key.scene->view().at(lit.pixels()[p]);
      const auto sights = lit.sights(p);
      ASSERT_EQ(sights.size(), lit.clusters(p).size());
      for (std::size_t i = 0; i < sights.size(); ++i) {
        if (!sights[i]) continue;
        ++count[*sights[i]];
        if (*sights[i] != Sight::seen && *sights[i] != Sight::hidden) continue;
        for (const std::uint32_t light : key.scene->topology().all_lights(lit.clusters(p)[i].node))
          EXPECT_EQ(key.scene->view().sees(at, light), *sights[i] == Sight::seen);
      }
    }
  // All of the four are there, so that the above says something.
  for (const Sight sight : {Sight::seen, Sight::hidden, Sight::ray, Sight::share})
    EXPECT_GT(count[sight], 20) << name_of(sight);
}

TEST(LitSquare, HasARayOnlyOfASingleLightAndWhatTheRaySaw) {
  for (const LitSquare& lit : small_squares())
    for (std::size_t p = 0; p < lit.pixels().size(); p += 5) {
      const SmallPoint sees(lit.pixels()[p]);
      const auto sights = lit.sights(p);
      std::size_t rays = 0;
      for (std::size_t i = 0; i < sights.size(); ++i) {
        if (sights[i] != Sight::ray) continue;
        ++rays;
        const auto lights = small_scene()->topology().all_lights(lit.clusters(p)[i].node);
        ASSERT_EQ(lights.size(), 1U);
        EXPECT_EQ(sees(lights[0]), lit.clusters(p)[i].visible);
      }
      EXPECT_LE(rays, lit.cut(p).shadow_rays);
    }
}

TEST(LitSquare, HasAllProvenWhereNothingOccludes) {
  const auto scene = opened("cloud?lights=100&blocks=0", {16, 8});
  ASSERT_FALSE(scene->view().may_occlude());
  const CutConfig config{.threshold = 0.02F, .unoccluded = true};
  const LitSquare lit(scene->view(), *scene->tree(), config, 1, {0, 0});
  ASSERT_FALSE(lit.pixels().empty());
  for (std::size_t p = 0; p < lit.pixels().size(); ++p) {
    EXPECT_EQ(lit.proven(p), 1);
    EXPECT_EQ(std::ranges::count(lit.block(p), p), 1);
    for (const auto& sight : lit.sights(p)) EXPECT_EQ(sight, Sight::seen);
  }
}

TEST(LitSquare, HasProvenTheShareOfItsEstimatesThatAreSeenOrHidden) {
  int between = 0;
  for (const LitSquare& lit : small_squares())
    for (std::size_t p = 0; p < lit.pixels().size(); ++p) {
      const auto sights = lit.sights(p);
      double seen = 0, open = 0;
      bool any_hidden = false;
      for (std::size_t i = 0; i < sights.size(); ++i) {
        const glm::dvec3& e = lit.clusters(p)[i].estimate;
        (sights[i] == Sight::seen ? seen : open) += e.x + e.y + e.z;
        any_hidden = any_hidden || sights[i] == Sight::hidden;
      }
      EXPECT_GE(lit.proven(p), 0);
      EXPECT_LE(lit.proven(p), 1);
      if (seen + open == 0) continue;
      // What is hidden counts, too.
      if (any_hidden)
        EXPECT_GE(lit.proven(p), seen / (seen + open) - 1e-9);
      else
        EXPECT_NEAR(lit.proven(p), seen / (seen + open), 1e-9);
      if (lit.proven(p) > 0.05 && lit.proven(p) < 0.95) ++between;
    }
  EXPECT_GT(between, 50);
}

} // namespace
} // namespace lightcuts::viz
