// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/visible_share.h>

#include <numeric>

#include <gtest/gtest.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

/// The lights of a far cluster, all but one for the points, seen as `sees` says.
struct FarCluster {
  LightTree tree;
  std::vector<BlockPoint> points = floor_points(8);
  std::vector<const ShadingPoint*> pointers = pointers_to(points);
  BlockEvidence evidence;
  VisibleShare share;

  template <class Sees>
  explicit FarCluster(Sees&& sees, std::vector<std::uint32_t> lookers = every())
      : tree(build(far_lights())), evidence(tree, false) {
    evidence.start(pointers, 1);
    std::vector<glm::vec2> places;
    for (const BlockPoint& p : points) places.push_back(p.place);
    share.start(places);
    const CutChain::Link link{0, glm::vec3(1e30F), false};
    evidence.look({&link, 1}, lookers,
                  [&](std::uint32_t p, std::uint32_t) { return sees(places[p]); });
  }
  static LightSet far_lights() {
    LightSet lights;
    lights.add_omni({0, 1000, 0}, glm::vec3(1));
    lights.add_omni({1, 1000, 0}, glm::vec3(1));
    return lights;
  }
  static std::vector<std::uint32_t> every() {
    std::vector<std::uint32_t> all(64);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }
  [[nodiscard]] double at(unsigned x, unsigned y) {
    return share.at(share.fit(evidence, 0, 0), 8 * y + x);
  }
};

TEST(VisibleShare, IsOneOrZeroWhereAllAgree) {
  FarCluster seen([](const glm::vec2&) { return true; });
  FarCluster hidden([](const glm::vec2&) { return false; });
  for (const unsigned i : {0U, 7U}) {
    EXPECT_EQ(seen.at(i, 7 - i), 1);
    EXPECT_EQ(hidden.at(i, 7 - i), 0);
  }
}

TEST(VisibleShare, LeansTowardsThoseWhoSee) {
  FarCluster half([](const glm::vec2& place) { return place.x < 4; });
  // Least squares of a step: mean 1/2, slope -12 (4 + 4^2 ...)/(8 (8^2 - 1)) = -4/21 a pixel.
  for (const unsigned y : {0U, 5U}) {
    EXPECT_NEAR(half.at(3, y), 0.5 + 0.5 * 4 / 21, 1e-4);
    EXPECT_NEAR(half.at(5, y), 0.5 - 1.5 * 4 / 21, 1e-4);
  }
  EXPECT_EQ(half.at(0, 3), 1) << "not above all";
  EXPECT_EQ(half.at(7, 3), 0);
}

TEST(VisibleShare, IsTheMeanOfFew) {
  FarCluster few([](const glm::vec2& place) { return place.x < 1; }, {0, 1, 2, 3});
  EXPECT_NEAR(few.at(0, 0), 0.25, 1e-4);
  EXPECT_NEAR(few.at(7, 7), 0.25, 1e-4);
}

TEST(VisibleShare, IsTheMeanAlongALine) {
  FarCluster line([](const glm::vec2& place) { return place.x < 2; },
                  {8, 9, 10, 11, 12, 13, 14, 15});
  EXPECT_NEAR(line.at(0, 1), 0.25, 1e-4);
  EXPECT_NEAR(line.at(7, 1), 0.25, 1e-4);
}

} // namespace
} // namespace lightcuts
