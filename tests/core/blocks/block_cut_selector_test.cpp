// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/block_cut_selector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/input_error.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

/// A wall hides a light of x > 0 from points of x < `edge`.
struct WalledFloor {
  LightTree tree = build(lights_above(300));
  std::vector<BlockPoint> points = floor_points(8);
  float edge = 0.35F;

  [[nodiscard]] bool sees(std::uint32_t p, std::uint32_t light) const {
    return tree.lights()[light].position.x < 0 || points[p].point.position().x >= edge;
  }
  [[nodiscard]] glm::dvec3 exact(std::uint32_t p) const {
    return sum_lights(tree.lights(), points[p].point,
                      [&](std::uint32_t light) { return sees(p, light); })
        .radiance;
  }
  [[nodiscard]] std::vector<BlockCut>
  cuts(const CutConfig& config, std::vector<std::vector<CutCluster>>* clusters = nullptr) const {
    BlockCutSelector select(tree, config);
    const auto found = select(
        points, 0, [&](std::uint32_t p, std::uint32_t light) { return sees(p, light); }, clusters);
    return {found.begin(), found.end()};
  }
};

double relative_error(const glm::vec3& radiance, const glm::dvec3& exact) {
  return std::abs(radiance.y - exact.y) / exact.y;
}

TEST(BlockCutSelector, ErrsByNoMoreThanItCertifies) {
  const WalledFloor lit;
  for (const float threshold : {0.02F, 0.1F, 0.5F}) {
    const auto cuts = lit.cuts({threshold});
    for (std::uint32_t p = 0; p < 64; ++p) {
      for (int c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(cuts[p].radiance[c] - lit.exact(p)[c]), cuts[p].certified_error[c]);
      EXPECT_EQ(cuts[p].end, CutEnd::converged);
    }
  }
}

TEST(BlockCutSelector, IsNearTheTruthInTheOpenAndAtTheHardestEdge) {
  // Half the light is cut off between two columns, where no plane fits.
  WalledFloor edge, open;
  open.edge = -1;
  const auto at_edge = edge.cuts({0.02F}), in_open = open.cuts({0.02F});
  for (std::uint32_t p = 0; p < 64; ++p) {
    EXPECT_LT(relative_error(at_edge[p].radiance, edge.exact(p)), 0.05) << p;
    EXPECT_LT(relative_error(in_open[p].radiance, open.exact(p)), 0.005) << p;
    EXPECT_LT(in_open[p].size, 200U);
  }
}

TEST(BlockCutSelector, AsksForFewerRaysThanClusters) {
  WalledFloor open;
  open.edge = -1; // everything is seen
  const auto cuts = open.cuts({0.05F});
  double clusters = 0, rays = 0;
  for (const BlockCut& cut : cuts) {
    clusters += cut.size;
    rays += cut.shadow_rays;
  }
  EXPECT_LT(rays, 0.4 * clusters);
}

TEST(BlockCutSelector, SaysOfEachPointItsClusters) {
  const WalledFloor lit;
  std::vector<std::vector<CutCluster>> clusters;
  const auto cuts = lit.cuts({0.05F}, &clusters);
  ASSERT_EQ(clusters.size(), 64U);
  for (std::uint32_t p = 0; p < 64; ++p) {
    glm::dvec3 total(0);
    std::uint32_t lights = 0;
    for (const CutCluster& c : clusters[p]) {
      total += c.estimate;
      lights += lit.tree.node(c.node).light_count;
    }
    EXPECT_EQ(glm::vec3(total), cuts[p].radiance);
    EXPECT_EQ(lights, 300U);
    EXPECT_EQ(clusters[p].size(), cuts[p].size);
    for (const CutCluster& c : clusters[p]) EXPECT_LE(c.bound.y, 0.05F * total.y);
  }
}

TEST(BlockCutSelector, PointsInTheDarkGoOnAlone) {
  WalledFloor lit;
  lit.edge = 0.05F; // the first column is dark but for lights of x < 0
  const auto cuts = lit.cuts({0.05F});
  EXPECT_GT(cuts[0].size, cuts[7].size);
}

TEST(BlockCutSelector, IsExactAtThresholdZero) {
  const WalledFloor lit;
  const auto cuts = lit.cuts({0});
  for (std::uint32_t p = 0; p < 64; ++p) {
    EXPECT_LT(relative_error(cuts[p].radiance, lit.exact(p)), 1e-6);
    EXPECT_EQ(cuts[p].size, 300U);
    EXPECT_EQ(cuts[p].end, CutEnd::converged);
  }
}

TEST(BlockCutSelector, EndsAtTheLargestSizeOrTheBlackLevel) {
  const WalledFloor lit;
  for (const BlockCut& cut : lit.cuts({0.001F, 20})) {
    EXPECT_EQ(cut.size, 20U);
    EXPECT_EQ(cut.end, CutEnd::max_size);
  }
  for (const BlockCut& cut : lit.cuts({0.001F, 1000, 0.05F}))
    EXPECT_EQ(cut.end, CutEnd::black_level);
}

TEST(BlockCutSelector, GivesTheSameBitsAgain) {
  const WalledFloor lit;
  BlockCutSelector select(lit.tree, {0.02F});
  const auto sees = [&](std::uint32_t p, std::uint32_t light) { return lit.sees(p, light); };
  const auto radiances = [&](std::uint64_t query) {
    std::vector<glm::vec3> list;
    for (const BlockCut& cut : select(lit.points, query, sees)) list.push_back(cut.radiance);
    return list;
  };
  const auto first = radiances(7);
  EXPECT_NE(radiances(8), first);
  EXPECT_EQ(radiances(7), first);
}

TEST(BlockCutSelector, PartsWhatIsNotOneSurface) {
  WalledFloor lit;
  for (std::uint32_t i = 0; i < 64; i += 2)
    lit.points[i].point = ShadingPoint(lit.points[i].point.position(), {0.6F, 0.8F, 0}, {0, 1, 0},
                                       {glm::vec3(0.5F), Phong{glm::vec3(0.3F), 10}});
  const auto cuts = lit.cuts({0.02F});
  for (std::uint32_t p = 0; p < 64; ++p)
    EXPECT_LT(relative_error(cuts[p].radiance, lit.exact(p)), 0.1) << p;
}

TEST(BlockCutSelector, OfNoLightsOrNoPointsIsNothing) {
  const LightTree none;
  const auto never = [](std::uint32_t, std::uint32_t) -> bool { throw 0; };
  const auto points = floor_points(2);
  BlockCutSelector dark(none);
  const auto cuts = dark(points, 0, never);
  ASSERT_EQ(cuts.size(), 4U);
  EXPECT_EQ(cuts[0].radiance, glm::vec3(0));
  const LightTree tree = build(lights_above(3));
  BlockCutSelector select(tree);
  EXPECT_EQ(select({}, 0, never).size(), 0U);
}

TEST(BlockCutSelector, RefusesAConfigurationOutOfItsDomain) {
  const LightTree tree = build(lights_above(3));
  EXPECT_THROW(BlockCutSelector(tree, {-1}), InputError);
  EXPECT_THROW(BlockCutSelector(tree, {std::numeric_limits<float>::quiet_NaN()}), InputError);
}

} // namespace
} // namespace lightcuts
