// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/visible_share.h>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

/// Far clusters of two lights each, all but one for the points; sees(cluster, place) says who is
/// seen.
struct FarClusters {
  LightTree tree;
  std::vector<BlockPoint> points = floor_points(8);
  std::vector<const ShadingPoint*> pointers = pointers_to(points);
  std::vector<CutChain::Link> links;
  BlockEvidence evidence;
  VisibleShare share;

  template <class Sees>
  FarClusters(unsigned count, Sees&& sees, std::vector<std::uint32_t> lookers = every())
      : tree(build(far_lights(count))), evidence(tree, false) {
    evidence.start(pointers, 1);
    std::vector<glm::vec2> places;
    for (const BlockPoint& p : points) places.push_back(p.place);
    share.start(places);
    for (std::uint32_t node = 0; node < tree.nodes().size(); ++node)
      if (!tree.node(node).is_leaf() && tree.node(tree.node(node).first_child).is_leaf())
        links.push_back({node, glm::vec3(1e30F), false});
    EXPECT_EQ(links.size(), count);
    evidence.look(links, lookers,
                  [&](std::uint32_t p, std::uint32_t light) { return sees(light / 2, places[p]); });
    share.observe(evidence, links, lookers);
  }
  static LightSet far_lights(unsigned count) {
    LightSet lights;
    for (unsigned i = 0; i < count; ++i)
      for (const float x : {0.0F, 1.0F})
        lights.add_omni({x, 1000, 16 * (float(i) - 0.5F * float(count))}, glm::vec3(1));
    return lights;
  }
  static std::vector<std::uint32_t> every() {
    std::vector<std::uint32_t> all(64);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }
  [[nodiscard]] float at(unsigned x, unsigned y, std::size_t place = 0) {
    const std::uint32_t p = 8 * y + x;
    float found = -1;
    share.at(place, {&p, 1}, {&found, 1});
    return found;
  }
};

/// Of one cluster.
struct FarCluster : FarClusters {
  template <class Sees>
  explicit FarCluster(Sees&& sees, std::vector<std::uint32_t> lookers = every())
      : FarClusters(
            1, [&](std::uint32_t /*cluster*/, const glm::vec2& place) { return sees(place); },
            std::move(lookers)) {}
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
  // Least squares of a step: mean 1/2, slope -12 (4 + 4^2 ...)/(8 (8^2 - 1)) = -4/21 a pixel. One
  // cluster hardly tells who is alike.
  for (const unsigned y : {0U, 5U}) {
    EXPECT_NEAR(half.at(3, y), 0.5 + 0.5 * 4 / 21, 0.1);
    EXPECT_NEAR(half.at(5, y), 0.5 - 1.5 * 4 / 21, 0.1);
  }
  EXPECT_EQ(half.at(0, 3), 1) << "not above all";
  EXPECT_EQ(half.at(7, 3), 0);
}

TEST(VisibleShare, FollowsTheEdgeThatManyClustersShare) {
  // A corner in the dark, where no plane fits: the best is off by 0.5. Of each cluster a tenth
  // differs by chance.
  gen::Dice dice(5);
  const auto is_dark = [](const glm::vec2& place) { return place.x >= 5 && place.y >= 4; };
  FarClusters many(100, [&](std::uint32_t, const glm::vec2& place) {
    return is_dark(place) == (dice.uniform(0, 1) < 0.1);
  });
  for (unsigned y = 0; y < 8; ++y)
    for (unsigned x = 0; x < 8; ++x) {
      double mean = 0;
      for (std::size_t place = 0; place < 100; ++place) mean += 0.01 * many.at(x, y, place);
      EXPECT_NEAR(mean, is_dark({x, y}) ? 0.1 : 0.9, 0.15) << x << ", " << y;
    }
}

TEST(VisibleShare, SmoothsWhatOnlyChanceParts) {
  gen::Dice dice(6);
  FarClusters many(100, [&](std::uint32_t, const glm::vec2&) { return dice.uniform(0, 1) < 0.5; });
  double off2 = 0;
  for (std::uint32_t i = 0; i < 6400; ++i) {
    const double off = many.at(i % 8, i / 8 % 8, i / 64) - 0.5;
    off2 += off * off / 6400;
  }
  // Of a plane fitted to 64 coins, three of them: sqrt(3/64)/2 = 0.108; of each coin alone 0.5.
  EXPECT_LT(std::sqrt(off2), 0.15);
}

// Who is alike is told by the one cluster itself there, which draws the mean to what each saw.
TEST(VisibleShare, IsTheMeanOfFew) {
  FarCluster few([](const glm::vec2& place) { return place.x < 1; }, {0, 1, 2, 3});
  EXPECT_NEAR(few.at(0, 0), 0.25, 0.02);
  EXPECT_NEAR(few.at(7, 7), 0.25, 0.02);
}

TEST(VisibleShare, IsTheMeanAlongALine) {
  FarCluster line([](const glm::vec2& place) { return place.x < 2; },
                  {8, 9, 10, 11, 12, 13, 14, 15});
  EXPECT_NEAR(line.at(0, 1), 0.25, 0.1);
  EXPECT_NEAR(line.at(7, 1), 0.25, 0.1);
}

} // namespace
} // namespace lightcuts
