// SPDX-License-Identifier: MIT
#include <oracle/truth/clairvoyant.h>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/methods/paper.h>
#include <tests/oracle/support/judged_point.h>
#include <tests/support/generators.h>

namespace lightcuts::oracle {
namespace {

struct Limits {
  double threshold, black_level;
};

/// By the definition: estimate and truth of the cluster differ by no more than is allowed.
bool good_enough(const JudgedPoint& judged, std::uint32_t i, const Limits& limits) {
  const TreeNode& node = judged.tree.node(i);
  if (node.is_leaf()) return true;
  const bool seen = judged.visible[node.representative] != 0;
  const glm::dvec3 estimate =
      seen ? transfer(judged.point, judged.tree.lights()[node.representative]) * node.intensity
           : glm::dvec3(0);
  for (int c = 0; c < 3; ++c) {
    const long double error = std::abs(estimate[c] - judged.truth.seen(i)[c]);
    if (error > limits.threshold * judged.truth.seen(0)[c] && error > limits.black_level)
      return false;
  }
  return true;
}

/// Sizes of all cuts below a node whose clusters are good enough.
std::vector<std::size_t> sizes_of_good_cuts(const JudgedPoint& judged, std::uint32_t i,
                                            const Limits& limits) {
  std::vector<std::size_t> sizes;
  if (good_enough(judged, i, limits)) sizes.push_back(1);
  const std::uint32_t a = judged.tree.node(i).first_child;
  if (a == 0) return sizes;
  for (const std::size_t left : sizes_of_good_cuts(judged, a, limits))
    for (const std::size_t right : sizes_of_good_cuts(judged, a + 1, limits))
      sizes.push_back(left + right);
  return sizes;
}

std::size_t found(const JudgedPoint& judged, const Limits& limits) {
  LibraryTree paper(judged.tree, library_kernel(all_light_kinds, methods::paper.rules));
  const auto estimate = [&](std::uint32_t node) {
    return seen_estimate({paper, library_parts}, node, judged.at());
  };
  return clairvoyant_cut_size(judged.truth, estimate, limits.threshold, limits.black_level);
}

RC_GTEST_PROP(ClairvoyantCut, IsTheSmallestOfAllGoodCuts, ()) {
  const gen::Scene scene = *gen::plain_scene(7);
  const auto mask = *rc::gen::arbitrary<unsigned>();
  std::vector<char> visible;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) visible.push_back((mask >> i) & 1U);
  const JudgedPoint judged(build(scene.light_set()), scene.view.point(), visible);
  const Limits limits{*rc::gen::element(0.0, 0.02, 0.2, 1.0), *rc::gen::element(0.0, 0.01, 1.0)};
  const auto sizes = sizes_of_good_cuts(judged, 0, limits);
  RC_CLASSIFY(sizes.size() > 1);
  RC_ASSERT(found(judged, limits) == *std::min_element(sizes.begin(), sizes.end()));
}

TEST(ClairvoyantCut, IsTheRootWhereAllIsAllowed) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  EXPECT_EQ(found(judged, {1e9, 0}), 1U);
  EXPECT_EQ(found(judged, {0, 1e9}), 1U);
}

TEST(ClairvoyantCut, IsEveryLightWhereNothingIsAllowed) {
  const JudgedPoint judged(four_lights(), diffuse_point({0.3F, 0.1F, 0}), {1, 1, 1, 1});
  EXPECT_EQ(found(judged, {0, 0}), 4U);
}

// Where nothing is seen the estimates are right: nothing.
TEST(ClairvoyantCut, IsTheRootInTheDark) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {0, 0, 0, 0});
  EXPECT_EQ(found(judged, {0, 0}), 1U);
}

TEST(ClairvoyantCut, OfNoLightsIsEmpty) {
  const JudgedPoint judged(LightTree(), diffuse_point(), {});
  EXPECT_EQ(found(judged, {0.02, 0}), 0U);
}

} // namespace
} // namespace lightcuts::oracle
