// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/cluster_index.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>

namespace lightcuts {
namespace {

std::vector<Cluster> clusters_of(const gen::Scene& scene) {
  std::vector<Cluster> list;
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const glm::vec3& p = light.position;
    const double weight = double(light.intensity.x) + light.intensity.y + light.intensity.z;
    list.push_back({{p, p}, {light.axis, light.axis}, weight, i, i});
  }
  return list;
}

Neighbour nearest_by_brute_force(const ClusterIndex& index, std::uint32_t self) {
  Neighbour best;
  for (std::uint32_t slot = 0; slot < index.slot_count(); ++slot) {
    if (slot == self || !index.holds_cluster(slot)) continue;
    const double cost = union_cost(index.at(self), index.at(slot));
    const std::uint32_t id = index.at(slot).id;
    if (std::pair(cost, id) < std::pair(best.cost, best.id)) best = {cost, id, slot};
  }
  return best;
}

void check_all(const ClusterIndex& index) {
  for (std::uint32_t slot = 0; slot < index.slot_count(); ++slot) {
    if (!index.holds_cluster(slot)) continue;
    const Neighbour expected = nearest_by_brute_force(index, slot);
    const Neighbour found = index.nearest(slot);
    RC_ASSERT(found.cost == expected.cost);
    RC_ASSERT(found.id == expected.id);
    if (std::isfinite(expected.cost)) RC_ASSERT(found.slot == expected.slot);
  }
}

/// A slot that holds a cluster, other than `not_this`.
std::uint32_t some_slot(const ClusterIndex& index, std::uint32_t not_this) {
  std::vector<std::uint32_t> held;
  for (std::uint32_t slot = 0; slot < index.slot_count(); ++slot)
    if (slot != not_this && index.holds_cluster(slot)) held.push_back(slot);
  return held[*rc::gen::arbitrary<std::uint32_t>() % held.size()];
}

/// Merges two clusters chosen at random, near or not.
void merge_any(ClusterIndex& index) {
  std::uint32_t a = some_slot(index, index.slot_count());
  std::uint32_t b = some_slot(index, a);
  if (index.at(b).id < index.at(a).id) std::swap(a, b);
  Cluster merged = index.at(a);
  merged.box.extend(index.at(b).box);
  merged.weight += index.at(b).weight;
  index.replace(a, b, merged);
}

RC_GTEST_PROP(ClusterIndex, FindsTheNearestThatBruteForceFinds, ()) {
  const gen::Scene scene = *gen::scene(60);
  check_all(ClusterIndex(clusters_of(scene)));
}

RC_GTEST_PROP(ClusterIndex, FindsTheNearestAfterAnyMerges, ()) {
  const gen::Scene scene = *gen::scene(30);
  ClusterIndex index(clusters_of(scene));
  for (std::size_t left = scene.lights.size(); left > 1; --left) {
    merge_any(index);
    if (left % 4 == 0 || left < 6) check_all(index);
    RC_ASSERT(index.clusters().size() == left - 1);
  }
}

RC_GTEST_PROP(ClusterIndex, HoldsWhatItWasGiven, ()) {
  const std::vector<Cluster> given = clusters_of(*gen::scene(60));
  std::vector<Cluster> held = ClusterIndex(given).clusters();
  std::sort(held.begin(), held.end(), [](auto& a, auto& b) { return a.id < b.id; });
  RC_ASSERT(held.size() == given.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    RC_ASSERT(held[i].id == i);
    RC_ASSERT(held[i].box == given[i].box);
  }
}

RC_GTEST_PROP(UnionCost, NeverFallsAsAClusterGrows, ()) {
  const auto any = [] { return clusters_of(*gen::scene(1))[0]; };
  const std::array<Cluster, 3> c{any(), any(), any()};
  Cluster grown = c[0];
  grown.box.extend(c[2].box);
  grown.axes.extend(c[2].axes);
  grown.weight += c[2].weight;
  RC_ASSERT(union_cost(c[0], c[1]) <= union_cost(grown, c[1]));
}

TEST(ClusterIndex, HasNoNearestForTheOnlyCluster) {
  const ClusterIndex index({Cluster{.box = {{0, 0, 0}, {0, 0, 0}}, .weight = 1}});
  EXPECT_EQ(index.nearest(0).cost, std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace lightcuts
