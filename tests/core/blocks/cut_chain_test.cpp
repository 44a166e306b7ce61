// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/cut_chain.h>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/kernels/contribution_bound.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

struct LitFloor {
  LightTree tree = build(lights_above(40));
  std::vector<BlockPoint> points = floor_points(4);
  ShadingBlock block = [this] {
    std::vector<ShadingPoint> plain;
    for (const BlockPoint& p : points) plain.push_back(p.point);
    return ShadingBlock(plain);
  }();
};

void expect_partition(const LightTree& tree, const CutChain& chain) {
  std::uint32_t lights = 0;
  std::set<std::uint32_t> nodes;
  for (const CutChain::Link& c : chain.clusters()) {
    lights += tree.node(c.node).light_count;
    nodes.insert(c.node);
  }
  EXPECT_EQ(lights, tree.lights().size());
  EXPECT_EQ(nodes.size(), chain.clusters().size());
}

TEST(CutChain, RefinesTheClusterOfTheLargestBound) {
  const LitFloor lit;
  CutChain chain(lit.tree, {});
  chain.start(lit.block);
  ASSERT_EQ(chain.clusters().size(), 1U);
  EXPECT_EQ(chain.clusters()[0].bound, contribution_bound(lit.tree, 0, lit.block));
  while (!chain.ended()) {
    const auto before = std::vector(chain.clusters().begin(), chain.clusters().end());
    const auto key = [](const CutChain::Link& c) {
      return std::max({c.bound.x, c.bound.y, c.bound.z});
    };
    const auto largest = std::ranges::max_element(before, {}, key);
    chain.advance_to(chain.steps() + 1);
    const auto place = std::size_t(largest - before.begin());
    const CutChain::Link& now = chain.clusters()[place];
    if (lit.tree.node(largest->node).is_leaf()) {
      EXPECT_TRUE(now.exact);
      EXPECT_EQ(now.bound, glm::vec3(0));
    } else {
      EXPECT_EQ(now.node, lit.tree.node(largest->node).first_child);
      EXPECT_EQ(chain.clusters().back().node, now.node + 1);
    }
    expect_partition(lit.tree, chain);
  }
  EXPECT_EQ(chain.clusters().size(), 40U);
  EXPECT_EQ(chain.steps(), 39U + 40U);
  EXPECT_EQ(chain.largest_bound(), glm::vec3(0));
}

TEST(CutChain, WeighsChannelsByTheTotal) {
  LightSet lights;
  lights.add_omni({-2, 1, 0}, {1, 0, 0});
  lights.add_omni({-2, 1.1F, 0}, {1, 0, 0});
  lights.add_omni({2, 1, 0}, {0, 2, 0});
  lights.add_omni({2, 1.1F, 0}, {0, 2, 0});
  const LightTree tree = build(lights);
  const LitFloor lit;
  const auto colour_refined_first = [&](const glm::dvec3& total) {
    CutChain chain(tree, {});
    chain.start(lit.block);
    chain.weigh(total);
    chain.advance_to(2);
    const auto split = std::ranges::count_if(chain.clusters(),
                                             [](const CutChain::Link& c) { return c.bound.x > 0; });
    return split == 2 ? "red" : "green";
  };
  EXPECT_STREQ(colour_refined_first({1, 1, 1}), "green");
  EXPECT_STREQ(colour_refined_first({1, 100, 1}), "red");
}

TEST(CutChain, LeavesOutTheBlackLevelAndEndsAtTheLargestSize) {
  const LitFloor lit;
  CutConfig config;
  config.max_size = 10;
  CutChain chain(lit.tree, config);
  chain.start(lit.block);
  chain.advance_to(1000);
  EXPECT_TRUE(chain.ended());
  EXPECT_EQ(chain.clusters().size(), 10U);
  const glm::vec3 largest = chain.largest_bound();
  EXPECT_GT(largest.x, 0);

  config.black_level = std::max({largest.x, largest.y, largest.z});
  CutChain dark(lit.tree, config);
  dark.start(lit.block);
  dark.advance_to(9);
  EXPECT_EQ(dark.largest_bound(), glm::vec3(0));
}

TEST(CutChain, TakesLeavesForExactWhereNothingOccludes) {
  const LitFloor lit;
  CutConfig config;
  config.unoccluded = true;
  CutChain chain(lit.tree, config);
  chain.start(lit.block);
  chain.advance_to(1000);
  EXPECT_EQ(chain.steps(), 39U);
}

} // namespace
} // namespace lightcuts
