// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene/texture.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <tests/render/support/refusal.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

/// 1 and 2 above 3 and 4, in all components.
Texture numbers() { return {{2, 2}, {glm::vec3(1), glm::vec3(2), glm::vec3(3), glm::vec3(4)}}; }

float number_at(double u, double v, const TextureWrap& wrap = {}) {
  const glm::vec3 colour = numbers().at({u, v}, wrap);
  EXPECT_EQ(colour, glm::vec3(colour.x));
  return colour.x;
}

TEST(Texture, HasItsFirstRowAtTheTop) {
  EXPECT_EQ(number_at(0.25, 0.75), 1);
  EXPECT_EQ(number_at(0.75, 0.75), 2);
  EXPECT_EQ(number_at(0.25, 0.25), 3);
  EXPECT_EQ(number_at(0.75, 0.25), 4);
}

TEST(Texture, KeepsTheComponentsApart) {
  const Texture texture({2, 1}, {{1, 2, 4}, {3, 8, 0}});
  EXPECT_EQ(texture.at({0.375, 0.5}), glm::vec3(1.5F, 3.5F, 3));
}

TEST(Texture, IsBilinearBetweenTheTexelsCentres) {
  EXPECT_EQ(number_at(0.375, 0.75), 1.25F);
  EXPECT_EQ(number_at(0.25, 0.375), 2.5F);
  EXPECT_EQ(number_at(0.5, 0.5), 2.5F);
  EXPECT_EQ(number_at(0.625, 0.375),
            1 * 0.25F * 0.25F + 2 * 0.75F * 0.25F + 3 * 0.25F * 0.75F + 4 * 0.75F * 0.75F);
}

TEST(Texture, Repeats) {
  EXPECT_EQ(number_at(0, 0.75), 1.5F); // between the last texel and the first
  EXPECT_EQ(number_at(1, 0.75), 1.5F);
  EXPECT_EQ(number_at(0.125, 0.75), 1.25F);
  EXPECT_EQ(number_at(0.25, 0), 2);
  EXPECT_EQ(number_at(7.25, -2.25), 1);
  EXPECT_EQ(number_at(-0.25, 5.25), 4);
}

TEST(Texture, RepeatsMirrored) {
  const TextureWrap mirror{Wrap::mirror, Wrap::repeat};
  EXPECT_EQ(number_at(0, 0.75, mirror), 1);
  EXPECT_EQ(number_at(1, 0.75, mirror), 2);
  EXPECT_EQ(number_at(1.25, 0.75, mirror), 2);
  EXPECT_EQ(number_at(1.5, 0.75, mirror), 1.5F);
  EXPECT_EQ(number_at(1.75, 0.75, mirror), 1);
  EXPECT_EQ(number_at(2, 0.75, mirror), 1);
  EXPECT_EQ(number_at(-0.25, 0.75, mirror), 1);
  EXPECT_EQ(number_at(-0.75, 0.75, mirror), 2);
  EXPECT_EQ(number_at(0.25, 1.25, {Wrap::repeat, Wrap::mirror}), 1);
}

TEST(Texture, GoesOnWithItsEdge) {
  const TextureWrap clamp{Wrap::clamp, Wrap::clamp};
  EXPECT_EQ(number_at(0, 1, clamp), 1);
  EXPECT_EQ(number_at(-9, 0.75, clamp), 1);
  EXPECT_EQ(number_at(9, 0.75, clamp), 2);
  EXPECT_EQ(number_at(0.25, -9, clamp), 3);
  EXPECT_EQ(number_at(0.5, 9, clamp), 1.5F);
}

TEST(Texture, HasAColourHoweverFarAway) {
  const double far = std::numeric_limits<float>::max(),
               near = std::numeric_limits<float>::denorm_min();
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
    for (const double u : {far, -far, near, -near, 1e15 + 0.5}) {
      const float number = number_at(u, -u, {wrap, wrap});
      EXPECT_TRUE(number >= 1 && number <= 4) << u << ": " << number;
    }
}

TEST(Texture, IsOneColourWhereItIsOneTexel) {
  const Texture texture({1, 1}, {{0.5F, 0.25F, 3}});
  for (const double x : {-0.3, 0.0, 0.5, 0.7, 1.0, 12.1})
    EXPECT_EQ(texture.at({x, x}), glm::vec3(0.5F, 0.25F, 3));
}

TEST(Texture, ClampsWhatIsNegativeOrNotFinite) {
  constexpr float largest = std::numeric_limits<float>::max();
  const Texture texture({4, 1}, {{-1, 2, 3}, {1, std::nanf(""), 3}, {1, 2, inf}, {1, 2, 3}});
  EXPECT_EQ(texture.clamped(), 3U);
  EXPECT_EQ(texture.at({0.125, 0.5}), glm::vec3(0, 2, 3));
  EXPECT_EQ(texture.at({0.375, 0.5}), glm::vec3(1, 0, 3));
  EXPECT_EQ(texture.at({0.625, 0.5}), glm::vec3(1, 2, largest));
  const Texture bright({2, 1}, {glm::vec3(inf), glm::vec3(inf)});
  for (int i = 0; i < 100; ++i) EXPECT_LE(bright.at({i / 97.0, 0.5}).x, largest);
}

TEST(Texture, RefusesSizesThatAreNone) {
  expect_refusal("0 x 1 texels", [] { Texture({0, 1}, {}); });
  expect_refusal("16385 x 1 texels", [] { Texture({16385, 1}, std::vector<glm::vec3>(16385)); });
  expect_refusal("3 texels for a texture of 2 x 2", [] {
    Texture({2, 2}, std::vector<glm::vec3>(3));
  });
}

} // namespace
} // namespace lightcuts
