// SPDX-License-Identifier: MIT
#include <oracle/cases/blocks.h>

#include <gtest/gtest.h>

#include <lightcuts/core/lobes/shading_block.h>
#include <oracle/cases/random_case.h>

namespace lightcuts::oracle {
namespace {

Case of_lobes(const Lobe& one, const Lobe& other) {
  Case c;
  c.views = {{{.material = {glm::vec3(1), one}}, {}}, {{.material = {glm::vec3(0), other}}, {}}};
  return c;
}

TEST(IsBlock, WhereLobesDifferInReflectanceOnly) {
  EXPECT_TRUE(is_block(of_lobes(NoLobe(), NoLobe())));
  EXPECT_TRUE(is_block(of_lobes(Phong{glm::vec3(1), 2}, Phong{glm::vec3(0.5F), 2})));
  EXPECT_FALSE(is_block(of_lobes(Phong{glm::vec3(1), 2}, Phong{glm::vec3(1), 3})));
  EXPECT_TRUE(is_block(of_lobes(Ward{glm::vec3(1), 0.5F}, Ward{glm::vec3(2), 0.5F})));
  EXPECT_FALSE(is_block(of_lobes(Ward{glm::vec3(1), 0.5F}, Ward{glm::vec3(1), 0.25F})));
  EXPECT_TRUE(is_block(of_lobes(CookTorrance{glm::vec3(1), 0.5F}, CookTorrance{{}, 0.5F})));
  EXPECT_FALSE(is_block(of_lobes(CookTorrance{{}, 0.5F}, Ward{glm::vec3(0), 0.5F})));
  EXPECT_FALSE(is_block(Case()));
}

// Else asking the library for a bound of it would throw.
TEST(IsBlock, IsWhatTheLibraryTakesForOne) {
  int blocks = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    if (many_lights_at(i) > 0) continue;
    const Case on = random_case(1, i);
    if (!is_block(on)) continue;
    ++blocks;
    std::vector<ShadingPoint> points;
    for (const CaseView& view : on.views) points.push_back(view.view.point());
    EXPECT_NO_THROW(ShadingBlock{points}) << i;
  }
  EXPECT_GT(blocks, 500);
}

TEST(MakeBlock, PutsNeighboursInPlaceOfOtherViews) {
  int bent = 0, recoloured = 0, apart = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Case c = random_case(1, 0);
    gen::Dice dice(seed);
    make_block(dice, c);
    EXPECT_TRUE(is_block(c));
    EXPECT_GE(c.views.size(), 2U);
    EXPECT_LE(c.views.size(), 5U);
    const gen::View &a = c.views[0].view, &b = c.views[1].view;
    bent += a.normal == b.normal ? 0 : 1;
    recoloured += a.material == b.material ? 0 : 1;
    apart += a.position == b.position ? 0 : 1;
  }
  for (const int some : {bent, recoloured, apart}) {
    EXPECT_GT(some, 50);
    EXPECT_LT(some, 190);
  }
}

} // namespace
} // namespace lightcuts::oracle
