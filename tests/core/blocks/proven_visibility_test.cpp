// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/proven_visibility.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <lightcuts/core/blocks/block_cut_selector.h>
#include <lightcuts/core/cut/sum_lights.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

/// A wall hides lights of x >= 0 from points of x < edge; others are seen.
class WallProver final : public ProvenVisibility {
public:
  WallProver(const std::vector<BlockPoint>& points, float edge) : points_(points), edge_(edge) {}

  void start(std::span<const std::uint32_t> points) override {
    const auto is_before = [&](std::uint32_t p) { return points_[p].point.position().x < edge_; };
    before_ = std::ranges::all_of(points, is_before);
    behind_ = std::ranges::none_of(points, is_before);
  }
  Proof prove(const TreeNode& cluster, const Proof& within) override {
    EXPECT_EQ(within.sight, ProvenSight::unknown) << "it is known of what is within";
    ++asked;
    if (cluster.box.hi.x < 0 || behind_) return {ProvenSight::seen};
    return {cluster.box.lo.x >= 0 && before_ ? ProvenSight::hidden : ProvenSight::unknown};
  }

  int asked = 0;

private:
  const std::vector<BlockPoint>& points_;
  float edge_;
  bool before_ = false, behind_ = false;
};

struct Wall {
  LightTree tree = build(lights_above(300));
  std::vector<BlockPoint> points = floor_points(8);
  float edge;
  int rays = 0;
  std::vector<std::vector<CutCluster>> clusters;

  explicit Wall(float edge_at) : edge(edge_at) {}

  [[nodiscard]] bool sees(std::uint32_t p, std::uint32_t light) const {
    return tree.lights()[light].position.x < 0 || points[p].point.position().x >= edge;
  }
  std::vector<BlockCut> cuts(ProvenVisibility* proven, float threshold = 0.02F) {
    BlockCutSelector select(tree, {threshold});
    const auto visible = [&](std::uint32_t p, std::uint32_t light) {
      ++rays;
      return sees(p, light);
    };
    const auto found = select(points, 0, {visible, proven}, &clusters);
    return {found.begin(), found.end()};
  }
};

TEST(ProvenVisibility, IsNotAskedOfButCertified) {
  for (const float edge : {-1.0F, 0.35F, 2.0F}) {
    Wall lit(edge), unproven(edge);
    WallProver prover(lit.points, edge);
    const auto cuts = lit.cuts(&prover), without = unproven.cuts(nullptr);
    EXPECT_GT(prover.asked, 0);
    if (edge < 0) {
      EXPECT_EQ(lit.rays, 0) << "all is seen";
    }
    EXPECT_LT(lit.rays, unproven.rays);
    for (std::uint32_t p = 0; p < 64; ++p) {
      const glm::dvec3 exact =
          sum_lights(lit.tree.lights(), lit.points[p].point, [&](std::uint32_t light) {
            return lit.sees(p, light);
          }).radiance;
      for (int c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(cuts[p].radiance[c] - exact[c]), cuts[p].certified_error[c]);
      EXPECT_LT(cuts[p].certified_error.y, 0.8F * without[p].certified_error.y) << edge << ' ' << p;
    }
  }
}

TEST(ProvenVisibility, HiddenClustersAreNotRefinedAndDark) {
  Wall lit(2);
  WallProver prover(lit.points, 2);
  const auto cuts = lit.cuts(&prover, 0);
  for (std::uint32_t p = 0; p < 64; ++p) {
    EXPECT_LT(cuts[p].size, 250U);
    for (const CutCluster& c : lit.clusters[p])
      if (lit.tree.node(c.node).box.lo.x >= 0) {
        EXPECT_FALSE(c.visible);
        EXPECT_EQ(c.estimate, glm::dvec3(0));
        EXPECT_EQ(c.bound, glm::vec3(0));
      }
  }
}

} // namespace
} // namespace lightcuts
