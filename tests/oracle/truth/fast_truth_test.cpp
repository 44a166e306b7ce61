// SPDX-License-Identifier: MIT
#include <oracle/subjects/library_subject.h>
#include <oracle/truth/fast_truth.h>

#include <cmath>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <tests/oracle/support/judged_point.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

std::vector<glm::vec3> bounds_of(const LightTree& tree, const ShadingPoint& point) {
  std::vector<glm::vec3> bounds(tree.nodes().size());
  contribution_bounds(tree, point, bounds);
  return bounds;
}

/// count lights in the upper half of a room of 10 m x 10 m x 5 m.
LightTree cloud(int count, gen::Dice& dice, float min_distance = 0) {
  LightSet lights;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 at = dice.in_cube();
    lights.add_omni({5 * at.x, 5 * at.y, 3.75F + 1.25F * at.z}, glm::abs(dice.in_cube()));
  }
  if (min_distance > 0) lights.set_min_distance(min_distance);
  return build(lights);
}

/// On the floor of that room, or anywhere in it.
ShadingPoint within_room(int i, gen::Dice& dice) {
  const glm::vec3 at = dice.in_cube();
  const glm::vec3 n = i % 2 == 0 ? glm::vec3(0, 0, 1) : dice.unit_vector();
  const float height = i % 4 == 0 ? 0 : 2.5F + 2.5F * at.z;
  return {{5 * at.x, 5 * at.y, height}, n, n, {{0.5F, 0.4F, 0.3F}, {}}};
}

RC_GTEST_PROP(FastTruth, LiesBetweenItsBars, ()) {
  const gen::Scene scene = *gen::scene_of(LightKind::omni, 0, *rc::gen::arbitrary<bool>());
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  Truth exact;
  const std::vector<char> visible(tree.lights().size(), 1);
  const Topology topology = *read_topology(claim_of(tree), tree.lights().size()).topology;
  exact.evaluate(topology, tree.lights(), point, visible);
  FastTruth fast(tree);
  fast.evaluate(point);
  for (std::uint32_t i = 0; i < fast.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const Exact truth = exact.exact_open(i, c);
      const Exact upper(fast.upper(i, c)), lower(fast.lower(i, c));
      RC_ASSERT(lower <= truth);
      RC_ASSERT(truth <= upper);
      RC_ASSERT(upper - lower <= upper * Exact(fast.relative_width()) * (1 + Exact(0x1p-8)));
      RC_ASSERT((truth == 0) == (upper == 0));
    }
}

// A chain: as high as it has lights, no library would build it.
TEST(FastTruth, TakesATreeOfAnyShape) {
  gen::Dice dice(3);
  std::vector<Light> lights;
  std::vector<FastNode> nodes;
  constexpr std::uint32_t count = 50;
  for (std::uint32_t i = 0; i < count; ++i) {
    lights.push_back({.position = glm::vec3(0, 0, 2) + dice.in_cube(), .intensity = glm::vec3(1)});
    if (i + 1 < count) nodes.push_back({2 * i + 2, 2 * i + 1}); // the chain goes on at 2 i + 2
    nodes.push_back({i, FastNode::no_child});
  }
  const ShadingPoint point = diffuse_point();
  FastTruth fast(lights, nodes, 0);
  fast.evaluate(point);
  Exact sum = 0;
  for (const Light& light : lights) sum += exact_contribution(light, point, 0, 1);
  EXPECT_LE(Exact(fast.lower(0, 1)), sum);
  EXPECT_GE(Exact(fast.upper(0, 1)), sum);
}

// What is left of n.q is 2^-100, and later 2^-70 of 2^80.
TEST(FastTruth, IsAccurateWhereTheDotProductCancels) {
  const auto expect_between = [](const Light& light, const ShadingPoint& point) {
    const FastNode leaf{0, FastNode::no_child};
    FastTruth fast(std::span(&light, 1), std::span(&leaf, 1), 0);
    fast.evaluate(point);
    const Exact truth = exact_contribution(light, point, 0, 0);
    EXPECT_GT(truth, 0);
    EXPECT_LE(Exact(fast.lower(0, 0)), truth);
    EXPECT_GE(Exact(fast.upper(0, 0)), truth);
  };
  const glm::vec3 normal(0.6F, -0.8F, 0x1p-100F);
  expect_between({.position = {0.8F, 0.6F, 1}, .intensity = glm::vec3(1)},
                 {glm::vec3(0), normal, normal, {glm::vec3(1), {}}});
  const glm::vec3 diagonal(std::sqrt(1 / 3.0F));
  expect_between({.position = {0x1p80F, 0x1p-70F, -0x1p80F}, .intensity = glm::vec3(1)},
                 {{-0x1p10F, 0x1p10F, 0}, diagonal, diagonal, {glm::vec3(1), {}}});
  // Lights that just cancel more or less than what is computed anew.
  gen::Dice dice(8);
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 n = dice.unit_vector(), at = dice.in_cube();
    const glm::vec3 along = at - glm::dot(at, n) / glm::dot(n, n) * n;
    const float up = std::ldexp(1.0F, -(i % 24));
    const ShadingPoint point(dice.in_cube(), n, n, {glm::vec3(1), {}});
    const Light light{.position = point.position() + along + up * n, .intensity = glm::vec3(1)};
    if (exact_contribution(light, point, 0, 0) > 0) expect_between(light, point);
  }
}

TEST(FastTruth, SupportsOmniLightsOnDiffuseSurfaces) {
  const Material diffuse{glm::vec3(1), {}};
  const Light omni, spot{.kind = LightKind::spot};
  EXPECT_TRUE(FastTruth::supports(std::span(&omni, 1), diffuse));
  EXPECT_FALSE(FastTruth::supports(std::span(&spot, 1), diffuse));
  EXPECT_FALSE(FastTruth::supports(std::span(&omni, 1), {glm::vec3(1), Phong{glm::vec3(1), 10}}));
}

/// Each verdict that is not left open is the exact one, with bounds that are raised or lowered by a
/// few ulps or a lot.
RC_GTEST_PROP(Compare, DecidesAsExactArithmeticDoes, ()) {
  const gen::Scene scene = *gen::scene_of(LightKind::omni, 0, *rc::gen::arbitrary<bool>());
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const std::vector<char> visible(tree.lights().size(), 1);
  Truth exact;
  const Topology topology = *read_topology(claim_of(tree), tree.lights().size()).topology;
  exact.evaluate(topology, tree.lights(), point, visible);
  FastTruth fast(tree);
  fast.evaluate(point);
  std::vector<glm::vec3> bounds = bounds_of(tree, point);
  for (glm::vec3& bound : bounds)
    for (int c = 0; c < 3; ++c)
      bound[c] *= *rc::gen::element(1.0F, 1 - 0x1p-23F, 1 - 0x1p-24F, 1 + 0x1p-20F, 0.5F, 2.0F);
  FastComparison result;
  compare(bounds, fast, result);
  std::vector<char> open(bounds.size(), 0);
  for (const std::uint32_t i : result.undecided) open[i] = 1;
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    bool holds = true;
    for (int c = 0; c < 3; ++c)
      holds = holds && (bounds[i][c] == inf || Exact(bounds[i][c]) >= exact.exact_open(i, c));
    RC_ASSERT((holds || open[i] != 0));
  }
}

TEST(Compare, FindsTheLargestRatioAndWhatIsTooLow) {
  const LightTree tree = four_lights();
  FastTruth fast(tree);
  fast.evaluate(diffuse_point());
  std::vector<glm::vec3> bounds;
  for (std::uint32_t i = 0; i < fast.size(); ++i)
    bounds.push_back(4.0F * glm::vec3(fast.upper(i, 0), fast.upper(i, 1), fast.upper(i, 2)));
  FastComparison result;
  bounds[3].y /= 2;
  bounds[5] = glm::vec3(inf);
  compare(bounds, fast, result);
  EXPECT_TRUE(result.undecided.empty());
  EXPECT_NEAR(result.worst_ratio, 0.5, 1e-6);
  EXPECT_EQ(result.worst_node, 3U);
  EXPECT_EQ(result.worst_channel, 1);

  bounds[1].z /= 5;
  bounds[2].x = std::nanf("");
  bounds[4].y = -1;
  bounds[6] = glm::vec3(0);
  compare(bounds, fast, result);
  EXPECT_THAT(result.undecided, testing::ElementsAre(1, 2, 4, 6));
  EXPECT_NEAR(result.worst_ratio, 0.5, 1e-6);
}

TEST(Compare, TakesInfinityForEnoughAndZeroForNothing) {
  const LightTree tree = four_lights();
  FastTruth fast(tree);
  FastComparison result;
  fast.evaluate(diffuse_point());
  compare(std::vector(fast.size(), glm::vec3(inf)), fast, result);
  EXPECT_TRUE(result.undecided.empty());
  EXPECT_EQ(result.worst_ratio, 0);
  fast.evaluate(diffuse_point({0, 0, 9})); // all lights are behind
  compare(std::vector(fast.size(), glm::vec3(0)), fast, result);
  EXPECT_TRUE(result.undecided.empty());
  EXPECT_EQ(result.worst_ratio, 0);
}

TEST(Compare, LeavesHardlyAnythingUndecided) {
  gen::Dice dice(2);
  for (const float min_distance : {0.0F, 0.5F}) {
    const LightTree tree = cloud(2000, dice, min_distance);
    FastTruth fast(tree);
    FastComparison result;
    std::size_t undecided = 0, all = 0;
    for (int i = 0; i < 100; ++i) {
      const ShadingPoint point = within_room(i, dice);
      fast.evaluate(point);
      compare(bounds_of(tree, point), fast, result);
      undecided += result.undecided.size();
      all += fast.size();
      EXPECT_TRUE(result.worst_ratio > 0.99 || fast.upper(0, 0) == 0);
      EXPECT_LE(result.worst_ratio, 1);
    }
    EXPECT_LT(double(undecided), 1e-3 * double(all));
  }
}

/// Bound, truth and comparison of every node: how many in a second on one core. Prints it; only the
/// counts are tested.
TEST(Throughput, OfComparingAllNodesWithTheTruth) {
  gen::Dice dice(1);
  const LightTree tree = cloud(20000, dice);
  std::vector<ShadingPoint> points;
  for (int i = 0; i < 32; ++i) points.push_back(within_room(i, dice));
  FastTruth fast(tree);
  FastComparison result;
  std::vector<glm::vec3> bounds(tree.nodes().size());
  std::array<double, 3> seconds{};
  std::size_t compared = 0, undecided = 0;
  auto last = Clock::now();
  const auto lap = [&](double& sum) {
    sum += seconds_since(last);
    last = Clock::now();
  };
  for (const ShadingPoint& point : points) {
    contribution_bounds(tree, point, bounds);
    lap(seconds[0]);
    fast.evaluate(point);
    lap(seconds[1]);
    compare(bounds, fast, result);
    lap(seconds[2]);
    compared += fast.size();
    undecided += result.undecided.size();
  }
  EXPECT_EQ(compared, points.size() * (2 * 20000 - 1));
  EXPECT_LT(double(undecided), 1e-3 * double(compared));
  const double all = seconds[0] + seconds[1] + seconds[2];
  const double ns = 1e9 / double(compared);
  std::cout << "20 000 lights: " << double(compared) / all * 1e-6
            << " million (node, point) comparisons per second; ns each: bound " << seconds[0] * ns
            << ", truth " << seconds[1] * ns << ", comparison " << seconds[2] * ns << '\n';
}

} // namespace
} // namespace lightcuts::oracle
