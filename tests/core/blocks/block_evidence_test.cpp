// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/block_evidence.h>

#include <map>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/kernels/contribution_bound.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

using Asked = std::multimap<std::uint32_t, std::uint32_t>; ///< lights by point

struct Looking {
  LightTree tree = build(lights_above(64));
  std::vector<BlockPoint> points = floor_points(8);
  std::vector<const ShadingPoint*> pointers = pointers_to(points);
  std::vector<std::uint32_t> all = std::vector<std::uint32_t>(64);
  BlockEvidence evidence{tree, false};
  Asked asked;

  explicit Looking(std::uint64_t seed = 1) {
    std::iota(all.begin(), all.end(), 0U);
    evidence.start(pointers, seed);
  }
  template <class Sees>
  void look(std::uint32_t node, Sees&& sees, bool exact = false) {
    const CutChain::Link link{node, exact ? glm::vec3(0) : glm::vec3(1e30F), exact};
    const auto visible = [&](std::uint32_t p, std::uint32_t light) {
      asked.emplace(p, light);
      return sees(p, light);
    };
    evidence.look({&link, 1}, all, visible);
  }
};

const auto all_is_seen = [](std::uint32_t, std::uint32_t) { return true; };

TEST(BlockEvidence, HasTheEstimateOfEachPoint) {
  Looking at;
  at.look(0, all_is_seen);
  for (std::uint32_t p = 0; p < 64; ++p) {
    EXPECT_EQ(at.evidence.open(0, p),
              cluster_estimate(at.tree, 0, at.points[p].point, glm::vec3(1e30F)));
    EXPECT_TRUE(at.evidence.sees(0, p));
    EXPECT_EQ(at.evidence.total(1, p), at.evidence.open(0, p));
  }
}

TEST(BlockEvidence, TakesAQuarterForAllWhereTheyAgree) {
  Looking at;
  at.look(0, all_is_seen);
  EXPECT_EQ(at.asked.size(), 16U);
  Looking dark;
  dark.look(0, [](std::uint32_t, std::uint32_t) { return false; });
  EXPECT_EQ(dark.asked.size(), 16U);
  for (std::uint32_t p = 0; p < 64; ++p) EXPECT_FALSE(dark.evidence.sees(0, p));
}

TEST(BlockEvidence, AsksAllWhereAQuarterDisagrees) {
  Looking at;
  at.look(0, [](std::uint32_t p, std::uint32_t) { return p % 8 < 4; });
  EXPECT_EQ(at.asked.size(), 64U);
  for (std::uint32_t p = 0; p < 64; ++p) {
    EXPECT_EQ(at.evidence.sees(0, p), p % 8 < 4);
    EXPECT_EQ(at.evidence.shadow_rays(p), 1U);
  }
}

TEST(BlockEvidence, TakesNothingOverFromNobody) {
  // Of any four neighbours in a row one is in the quarter: these lie on three of the four places.
  for (std::uint32_t left_out = 0; left_out < 4; ++left_out) {
    Looking at;
    std::erase_if(at.all, [&](std::uint32_t p) { return (p + 2 * (p / 8)) % 4 == left_out; });
    at.look(0, [](std::uint32_t, std::uint32_t) { return false; });
    for (const std::uint32_t p : at.all) EXPECT_FALSE(at.evidence.sees(0, p)) << p;
  }
}

TEST(BlockEvidence, SpreadsTheLightsThatAreAskedForByIntensity) {
  // Stratified: over n draws each light is asked for n times its share, to within a few.
  std::map<std::uint32_t, double> times;
  const Looking first;
  const auto sees = [](std::uint32_t p, std::uint32_t) { return p % 8 < 4; };
  constexpr int repeats = 200;
  for (int seed = 0; seed < repeats; ++seed) {
    Looking at(seed);
    at.look(0, sees);
    for (const auto& [point, light] : at.asked) ++times[light];
  }
  double sum = 0;
  const auto weight = [](const Light& l) {
    return double(l.intensity.x) + l.intensity.y + l.intensity.z;
  };
  for (const Light& light : first.tree.lights()) sum += weight(light);
  // 12 800 draws, 200 for a light in the mean: five deviations of independent ones are 0.35.
  for (std::uint32_t i = 0; i < 64; ++i)
    EXPECT_NEAR(times[i] / (64.0 * repeats * weight(first.tree.lights()[i]) / sum), 1, 0.35);
}

TEST(BlockEvidence, AsksEachPointForTheSameLightWhoeverElseLooks) {
  const auto sees = [](std::uint32_t p, std::uint32_t) { return p % 8 < 4; };
  Looking together, alone;
  together.look(0, sees);
  alone.all = {21};
  alone.look(0, sees);
  ASSERT_EQ(alone.asked.size(), 1U);
  EXPECT_EQ(alone.asked.find(21)->second, together.asked.find(21)->second);
}

TEST(BlockEvidence, OfAnExactLeafEachSeesForItself) {
  Looking at;
  std::uint32_t leaf = 0;
  while (!at.tree.node(leaf).is_leaf()) leaf = at.tree.node(leaf).first_child;
  const auto sees = [](std::uint32_t p, std::uint32_t) { return p != 37; };
  at.look(leaf, sees);
  at.look(leaf, sees, true);
  EXPECT_EQ(at.asked.size(), 64U) << "nobody twice";
  for (std::uint32_t p = 0; p < 64; ++p) EXPECT_EQ(at.evidence.sees(0, p), p != 37);
}

TEST(BlockEvidence, LetsAPointLookForItself) {
  Looking at;
  at.look(0, all_is_seen);
  std::uint32_t quiet = 0;
  while (at.asked.contains(quiet)) ++quiet;
  const CutChain::Link link{0, glm::vec3(1e30F), false};
  const auto hidden = [&](std::uint32_t p, std::uint32_t light) {
    at.asked.emplace(p, light);
    return false;
  };
  EXPECT_TRUE(at.evidence.look_for_itself({&link, 1}, quiet, hidden));
  EXPECT_EQ(at.asked.count(quiet), 1U);
  EXPECT_FALSE(at.evidence.sees(0, quiet));
  EXPECT_FALSE(at.evidence.look_for_itself({&link, 1}, quiet, hidden));
  EXPECT_EQ(at.asked.count(quiet), 1U) << "it has";
}

TEST(BlockEvidence, AsksForSeveralLightsWhereAPointLooksClosely) {
  Looking at;
  at.look(0, all_is_seen);
  const std::uint32_t rays = at.evidence.shadow_rays(9);
  const CutChain::Link link{0, glm::vec3(1e30F), false};
  std::vector<float> shares;
  std::set<std::uint32_t> lights;
  at.evidence.look_closely(
      {&link, 1}, 9,
      [&](std::uint32_t p, std::uint32_t light) {
        EXPECT_EQ(p, 9U);
        lights.insert(light);
        return light % 2 == 0;
      },
      shares);
  EXPECT_GE(lights.size(), 4U);
  EXPECT_GT(at.evidence.shadow_rays(9), rays + 3);
  ASSERT_EQ(shares.size(), 1U);
  EXPECT_GT(shares[0], 0);
  EXPECT_LT(shares[0], 1);
}

TEST(BlockEvidence, AsksNothingWhereNothingOccludes) {
  Looking at;
  at.evidence = BlockEvidence(at.tree, true);
  at.evidence.start(at.pointers, 1);
  at.look(0, [](std::uint32_t, std::uint32_t) { return false; });
  EXPECT_EQ(at.asked.size(), 0U);
  EXPECT_TRUE(at.evidence.sees(0, 5));
}

} // namespace
} // namespace lightcuts
