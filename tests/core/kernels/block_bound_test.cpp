// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/block_bound.h>

#include <cmath>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;

/// A scene and neighbouring views of one surface, as far apart as chance has it.
struct BlockCase {
  gen::Scene scene;
  std::vector<gen::View> views;

  [[nodiscard]] std::vector<ShadingPoint> points() const {
    std::vector<ShadingPoint> list;
    for (const gen::View& v : views) list.push_back(v.point());
    return list;
  }
};

glm::vec3 turned(gen::Dice& dice, const glm::vec3& direction, double by) {
  const glm::dvec3 offset(dice.uniform(-by, by), dice.uniform(-by, by), dice.uniform(-by, by));
  return glm::vec3(glm::normalize(glm::dvec3(direction) + offset));
}

BlockCase block_case(std::uint64_t seed) {
  gen::Dice dice(seed);
  BlockCase c{gen::make_scene(dice, dice.between(1, 8)), {}};
  c.views.push_back(c.scene.view);
  float size = 1;
  for (const Light& light : c.scene.lights)
    size = std::max(size, glm::distance(light.position, c.scene.view.position));
  const float apart = dice.pick({0.0F, 1e-6F, 0.01F, 0.3F}) * std::min(size, 1e15F);
  const double bent = dice.pick({0.0, 1e-6, 0.05, 0.7});
  const int count = dice.between(1, 4);
  for (int i = 1; i < count; ++i) {
    gen::View v = c.scene.view;
    for (int k = 0; k < 3; ++k) v.position[k] += apart * float(dice.uniform(-1, 1));
    v.normal = turned(dice, v.normal, bent);
    v.to_viewer = turned(dice, v.to_viewer, bent);
    v.material.diffuse =
        glm::min(v.material.diffuse * float(dice.uniform(0, 2)), glm::vec3(0x1p127F));
    c.views.push_back(v);
  }
  return c;
}

/// Of how many (node, point, channel) of the case the bound is wrong, by 113 bits; -1: it is NaN.
template <class Bound, class IsWrong>
int count_wrong(const BlockCase& c, Bound&& bound_of, IsWrong&& is_wrong) {
  const LightTree tree = build(c.scene.light_set());
  int count = 0;
  for (const ShadingPoint& point : c.points()) {
    const std::vector<Colour> truth = precise::contributions(tree, point);
    for (std::uint32_t i = 0; i < truth.size(); ++i) {
      const glm::vec3 bound = bound_of(tree, i);
      for (int k = 0; k < 3; ++k) {
        if (std::isnan(bound[k])) return -1;
        if (is_wrong(truth[i][k], bound[k])) ++count;
      }
    }
  }
  return count;
}

/// Of how many the truth lies above the block's bound.
int violations(const BlockCase& c, const ShadingBlock& block) {
  return count_wrong(
      c, [&](const LightTree& tree, std::uint32_t i) { return contribution_bound(tree, i, block); },
      [](const Quad& truth, float bound) { return !std::isinf(bound) && truth > Quad(bound); });
}

/// Of how many it lies below the block's lower bound.
int violations_below(const BlockCase& c, const ShadingBlock& block) {
  return count_wrong(
      c,
      [&](const LightTree& tree, std::uint32_t i) {
        return contribution_lower_bound(tree, i, block);
      },
      [](const Quad& truth, float bound) { return truth < Quad(bound); });
}

RC_GTEST_PROP(BlockBound, DominatesTheTruthOfEachPoint, ()) {
  const BlockCase c = block_case(*rc::gen::arbitrary<std::uint64_t>());
  RC_ASSERT(violations(c, ShadingBlock(c.points())) == 0);
}

// Of lobes a block takes angles where a point takes quicker bounds, which may be looser.
RC_GTEST_PROP(BlockBound, OfDiffuseSurfacesDominatesTheBoundOfEachPoint, ()) {
  BlockCase c = block_case(*rc::gen::arbitrary<std::uint64_t>());
  for (gen::View& v : c.views) v.material.lobe = NoLobe();
  const LightTree tree = build(c.scene.light_set());
  const std::vector<ShadingPoint> points = c.points();
  const ShadingBlock block(points);
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const glm::vec3 bound = contribution_bound(tree, i, block);
    for (const ShadingPoint& point : points)
      for (int k = 0; k < 3; ++k)
        // Both are rounded up, in their own ways.
        RC_ASSERT(contribution_bound(tree, i, point)[k] <=
                  double(bound[k]) * (1 + 4 * bound_excess) + 0x1p-149);
  }
}

// All kinds and lobes on the same seeds as always: 20 000 blocks.
TEST(BlockBound, HoldsInManyBlocksOfAllKindsAndLobes) {
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    const BlockCase c = block_case(seed);
    ASSERT_EQ(violations(c, ShadingBlock(c.points())), 0) << "seed " << seed;
  }
}

TEST(BlockLowerBound, HoldsInManyBlocksOfAllKindsAndLobes) {
  int positive = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    const BlockCase c = block_case(seed);
    const ShadingBlock block(c.points());
    ASSERT_EQ(violations_below(c, block), 0) << "seed " << seed;
    if (contribution_lower_bound(build(c.scene.light_set()), 0, block) != glm::vec3(0)) ++positive;
  }
  EXPECT_GT(positive, 500);
}

/// Whether the truth convicts a block that was made of other points than it is judged by.
bool convicts(int (*violations_of)(const BlockCase&, const ShadingBlock&),
              const std::function<void(std::vector<gen::View>&)>& alter) {
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const BlockCase c = block_case(seed);
    BlockCase altered = c;
    alter(altered.views);
    if (violations_of(c, ShadingBlock(altered.points())) != 0) return true;
  }
  return false;
}

TEST(BlockBound, IsConvictedWhereItIsWrong) {
  using Views = std::vector<gen::View>;
  for (const auto bound : {violations, violations_below}) {
    EXPECT_FALSE(convicts(bound, [](Views&) {}));
    // a corner of the block's box forgotten
    EXPECT_TRUE(convicts(bound, [](Views& v) { v.back().position = v.front().position; }));
    // the cone of normals not widened
    EXPECT_TRUE(convicts(bound, [](Views& v) { v.back().normal = v.front().normal; }));
    // the reflectance of the first point
    EXPECT_TRUE(convicts(bound, [](Views& v) {
      for (gen::View& view : v) view.material = v.front().material;
    }));
  }
  // the viewers' cone not widened, nor that of mirror directions
  EXPECT_TRUE(convicts(violations, [](Views& v) { v.back().to_viewer = v.front().to_viewer; }));
}

TEST(BlockBounds, OfOnePointAreThoseOfThePoint) {
  LightSet lights;
  lights.add_omni({1, 2, 2}, glm::vec3(1));
  lights.add_omni({2, 1, 3}, glm::vec3(2));
  const LightTree tree = build(lights);
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(0.5F), {}});
  const ShadingBlock block({&point, 1});
  EXPECT_EQ(contribution_bound(tree, 0, block), contribution_bound(tree, 0, point));
  EXPECT_GT(contribution_lower_bound(tree, 0, point).x, 0);
  EXPECT_EQ(contribution_lower_bound(tree, 0, block), contribution_lower_bound(tree, 0, point));
}

TEST(ShadingBlock, RefusesNoPointsAndLobesOfDifferentShape) {
  const auto with = [](const Lobe& lobe) {
    return ShadingPoint({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), lobe});
  };
  EXPECT_THROW(ShadingBlock({}), InputError);
  const std::vector<ShadingPoint> shapes{with(Phong{glm::vec3(1), 2}),
                                         with(Phong{glm::vec3(1), 3})};
  EXPECT_THROW((ShadingBlock{shapes}), InputError);
  const std::vector<ShadingPoint> kinds{with(NoLobe()), with(Ward{glm::vec3(1), 0.5F})};
  EXPECT_THROW((ShadingBlock{kinds}), InputError);
  const std::vector<ShadingPoint> brighter{with(Phong{glm::vec3(1, 0, 0), 2}),
                                           with(Phong{glm::vec3(0, 1, 0), 2})};
  EXPECT_EQ(std::get<Phong>(ShadingBlock(brighter).material().lobe).reflectance,
            glm::vec3(1, 1, 0));
}

} // namespace
} // namespace lightcuts
