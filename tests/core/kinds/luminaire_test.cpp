// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/luminaire.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/numbers/dice.h>
#include <oracle/truth/kinds.h>

namespace lightcuts {
namespace {

/// Four half-planes; the axis is +z, horizontal angle 0 is +x.
Light four_planes() {
  return {.kind = LightKind::profile,
          .axis = {0, 0, 1},
          .plane = {1, 0, 0},
          .profile = Profile({.cosines = {1, 0.5F, 0, -0x1p-20F, -1},
                              .plane_cosines = {1, 0, -1, 0},
                              .plane_sines = {0, 1, 0, -1},
                              .shares = {1, 0.5F, 0.25F, 0, 0, 1, 1,     0.125F, 0, 0,
                                         1, 0,    0,     0, 0, 1, 0.75F, 1,      0, 0}})};
}

TEST(Luminaire, HasTheTableAtItsRowsAndHalfPlanes) {
  const Light light = four_planes();
  EXPECT_EQ(Luminaire::emission(light, {0, 0, 3}), 1);
  EXPECT_EQ(Luminaire::emission(light, {2, 0, 0}), 0.25);
  EXPECT_EQ(Luminaire::emission(light, {-2, 0, 0}), 0);
  EXPECT_EQ(Luminaire::emission(light, {2, 0, -1e-5F}), 0);
}

// Counterclockwise seen against the axis: from behind the light, +y is at its right.
TEST(Luminaire, CountsHorizontalAnglesAgainstTheClockForOneWhoSeesTheLightFromBehind) {
  EXPECT_EQ(Luminaire::emission(four_planes(), {0, -2, 0}), 0.125);
  EXPECT_EQ(Luminaire::emission(four_planes(), {0, 2, 0}), 1);
}

TEST(Luminaire, IsLinearInTheCosineAndAlongTheChord) {
  const Light light = four_planes();
  EXPECT_NEAR(Luminaire::emission(light, {0.6614378F, 0, 0.75F}), 0.75, 1e-6);
  // Midway between two half-planes, and at a third of the chord.
  EXPECT_NEAR(Luminaire::emission(light, {1, -1, 0}), 0.5 * (0.25 + 0.125), 1e-12);
  EXPECT_NEAR(Luminaire::emission(light, {2, -1, 0}), (2 * 0.25 + 0.125) / 3, 1e-12);
}

TEST(Luminaire, AtThePointSendsNothing) {
  EXPECT_EQ(Luminaire::emission(four_planes(), {0, 0, 0}), 0);
}

Light random_luminaire(gen::Dice& dice, const glm::vec3& x) {
  Light light{.kind = LightKind::profile, .position = dice.in_cube(), .intensity = glm::vec3(1)};
  oracle::radiometry::KindTruth<LightKind::profile>::finish(dice, light, x);
  return light;
}

/// The largest emission towards x of the lights below a node.
double most_below(const LightTree& tree, std::uint32_t node, const glm::vec3& x) {
  const TreeNode& n = tree.node(node);
  if (n.is_leaf()) return Luminaire::emission(tree.lights()[n.representative], x);
  return std::max(most_below(tree, n.first_child, x), most_below(tree, n.first_child + 1, x));
}

enum class Alike { nothing, profiles, frames };

void expect_bounded(Alike alike, std::uint64_t seed) {
  gen::Dice dice(seed);
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 x = dice.in_cube();
    const float size = dice.pick({1.0F, 0.125F, 0.001F});
    const Light model = random_luminaire(dice, x);
    LightSet lights;
    for (int k = 0; k < 6; ++k) {
      Light light = random_luminaire(dice, x);
      light.position = model.position + size * dice.in_cube();
      if (alike != Alike::nothing) light.profile = model.profile;
      if (alike == Alike::frames) light.axis = model.axis;
      if (alike == Alike::frames) light.plane = model.plane;
      lights.add(light);
    }
    const LightTree tree = build(lights);
    for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
      if (alike == Alike::frames || tree.node(node).is_leaf()) {
        ASSERT_TRUE(tree.emission(node).profile->one_frame);
      }
      const DifferenceBox q(x, tree.node(node).box);
      ASSERT_GE(Luminaire::max_emission(tree.emission(node), q), most_below(tree, node, x))
          << i << ", node " << node;
    }
  }
}

TEST(Luminaire, OfAnyKindIsBoundedOverItsCluster) { expect_bounded(Alike::nothing, 1); }
TEST(Luminaire, OfOneMakeIsBoundedOverItsCluster) { expect_bounded(Alike::profiles, 2); }
TEST(Luminaire, OfOneMakeAndTurnIsBoundedOverItsCluster) { expect_bounded(Alike::frames, 3); }

/// The largest emission from a grid of places in a box.
double most_of_grid(Light light, const Box& box, const glm::vec3& x) {
  constexpr int steps = 24;
  double most = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k) {
        light.position = glm::vec3(glm::dvec3(box.lo) + glm::dvec3(i, j, k) / double(steps) *
                                                            glm::dvec3(box.hi - box.lo));
        most = std::max(most, Luminaire::emission(light, x));
      }
  return most;
}

// In one frame nothing but the two ranges' being taken for independent is given away.
TEST(Luminaire, IsBoundedTightlyWhereAllAreAlike) {
  gen::Dice dice(9);
  double worst = 1, sum = 0;
  int cases = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 x(0);
    Light light = four_planes();
    const glm::vec3 centre = 4.0F * dice.in_cube() + glm::vec3(0, 0, -3);
    const Box box{centre - glm::vec3(0.2F), centre + glm::vec3(0.2F)};
    const double real = most_of_grid(light, box, x);
    if (real == 0) continue;
    ClusterEmission e{.cone = {light.axis, 0}};
    e.profile = std::make_shared<ClusterProfile>(
        ClusterProfile{light.profile, light.profile, light.plane, true});
    const double bound = Luminaire::max_emission(e, DifferenceBox(x, box));
    EXPECT_GE(bound, real);
    worst = std::max(worst, bound / real);
    sum += bound / real;
    ++cases;
  }
  ASSERT_GT(cases, 30);
  EXPECT_LT(sum / cases, 1.05);
  EXPECT_LT(worst, 1.3);
}

} // namespace
} // namespace lightcuts
