// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/morton_order.h>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/dendrogram.h>
#include <tests/support/generators.h>
#include <tests/support/naive_morton_order.h>

namespace lightcuts {
namespace {

std::vector<Cluster> in_order(std::vector<Cluster> clusters) {
  sort_by_morton_order(clusters);
  return clusters;
}

std::vector<Cluster> points(const std::vector<glm::vec3>& positions) {
  std::vector<Cluster> clusters;
  for (const glm::vec3& p : positions) {
    const auto id = std::uint32_t(clusters.size());
    clusters.push_back({.box = {p, p}, .weight = 1, .id = id, .node = id});
  }
  return clusters;
}

std::vector<std::uint32_t> ids(const std::vector<Cluster>& clusters) {
  std::vector<std::uint32_t> all;
  for (const Cluster& c : clusters) all.push_back(c.id);
  return all;
}

TEST(MortonOrder, OfTheCornersOfACubeTakesXBeforeYBeforeZ) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({float(i / 4), float(i / 2 % 2), float(i % 2)});
  EXPECT_EQ(ids(in_order(points(corners))), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  std::reverse(corners.begin(), corners.end());
  EXPECT_EQ(ids(in_order(points(corners))), (std::vector<std::uint32_t>{7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST(MortonOrder, KeepsApartWhatIsOneCellOfFewerBits) {
  // Two clumps, each a millionth of a millionth of the whole in size.
  const float tiny = 1e-12F;
  EXPECT_EQ(ids(in_order(points({{1, 0, 0}, {2 * tiny, 0, 0}, {0, 0, 0}, {tiny, 0, 0}}))),
            (std::vector<std::uint32_t>{2, 3, 1, 0}));
}

TEST(MortonOrder, TellsAxesApartWherePositionsAreOne) {
  std::vector<Cluster> clusters = points(std::vector<glm::vec3>(6, glm::vec3(3)));
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const glm::vec3 axis(0, 0, i % 2 == 0 ? 1 : -1);
    clusters[i].axes = {axis, axis};
  }
  EXPECT_EQ(ids(in_order(clusters)), (std::vector<std::uint32_t>{1, 3, 5, 0, 2, 4}));
}

RC_GTEST_PROP(MortonOrder, IsThatOfInterleavedBits, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, 60)).light_set();
  const std::vector<Cluster> clusters = Dendrogram(lights, {}).clusters_of(kind);
  RC_ASSERT(ids(in_order(clusters)) == naive_morton_order(clusters));
}

} // namespace
} // namespace lightcuts
