// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/locally_ordered_clustering.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>
#include <tests/support/naive_difference.h>
#include <tests/support/naive_morton_order.h>

namespace lightcuts {
namespace {

using oracle::NaiveCluster;

struct Placed {
  std::uint32_t place; ///< on the curve
  std::int32_t cluster;
};

NaiveCluster merged(const std::vector<NaiveCluster>& all, std::int32_t a, std::int32_t b) {
  const NaiveCluster& first = all[std::size_t(a)];
  const NaiveCluster& second = all[std::size_t(b)];
  NaiveCluster m = first.first < second.first ? first : second;
  m.box.extend(first.first < second.first ? second.box : first.box);
  m.axes.extend(first.first < second.first ? second.axes : first.axes);
  m.intensity = first.intensity + second.intensity;
  m.weight = first.weight + second.weight;
  m.light_count = first.light_count + second.light_count;
  m.children[0] = first.first < second.first ? a : b;
  m.children[1] = first.first < second.first ? b : a;
  return m;
}

/// The index in `open` of the cheapest partner of open[i].
std::size_t choice_of(std::size_t i, const std::vector<Placed>& open,
                      const std::vector<NaiveCluster>& all) {
  const auto rank = [&](std::size_t j) {
    return std::tuple(
        oracle::greedy_metric(all[std::size_t(open[i].cluster)], all[std::size_t(open[j].cluster)]),
        open[i].place ^ open[j].place, std::min(open[i].place, open[j].place));
  };
  std::size_t best = open.size();
  for (std::size_t j = 0; j < open.size(); ++j) {
    const std::size_t apart = i < j ? j - i : i - j;
    if (apart == 0 || apart > search_radius) continue;
    if (best == open.size() || rank(j) < rank(best)) best = j;
  }
  return best;
}

/// The definition, by the letter: in each round everybody chooses anew. Lights of one kind; the
/// last cluster is the root.
std::vector<NaiveCluster> naive_local_clusters(const LightSet& lights) {
  std::vector<NaiveCluster> all = oracle::naive_clusters(lights);
  all.resize(lights.size()); // the lights themselves
  std::vector<Placed> open;
  for (const std::uint32_t light :
       naive_morton_order(Dendrogram(lights, {}).clusters_of(lights[0].kind)))
    open.push_back({std::uint32_t(open.size()), std::int32_t(light)});
  while (open.size() > 1) {
    std::vector<std::size_t> choice;
    for (std::size_t i = 0; i < open.size(); ++i) choice.push_back(choice_of(i, open, all));
    std::vector<Placed> next;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (choice[choice[i]] != i) {
        next.push_back(open[i]);
      } else if (i < choice[i]) {
        all.push_back(merged(all, open[i].cluster, open[choice[i]].cluster));
        next.push_back({open[i].place, std::int32_t(all.size() - 1)});
      }
    }
    open = next;
  }
  return all;
}

std::string difference_from_naive(const LightSet& lights) {
  return difference(build(lights, {1, Builder::locally_ordered}), naive_local_clusters(lights));
}

RC_GTEST_PROP(LocallyOrderedClustering, IsThatOfRoundsInWhichAllChooseAnew, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, 60)).light_set();
  RC_ASSERT(difference_from_naive(lights) == "");
}

RC_GTEST_PROP(LocallyOrderedClustering, OfClumpsOfLightsIsThatOfRounds, ()) {
  gen::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  LightSet lights;
  for (int i = 0; i < 120; ++i) {
    const float size = std::exp2(float(i % 7) * -4);
    lights.add_omni(size * dice.in_cube(), glm::vec3(float(1 + i * i % 11)));
  }
  RC_ASSERT(difference_from_naive(lights) == "");
}

TEST(LocallyOrderedClustering, OfAFullLatticeIsThatOfRounds) {
  LightSet lights; // every distance occurs many times
  for (int i = 0; i < 216; ++i)
    lights.add_omni({i * 7 % 216 % 6, i * 7 % 216 / 6 % 6, i * 7 % 216 / 36}, glm::vec3(1));
  EXPECT_EQ(difference_from_naive(lights), "");
}

// Each is nearest to the one before, so in the first round one pair alone merges.
TEST(LocallyOrderedClustering, OfEverBrighterLightsInARowIsThatOfRounds) {
  LightSet lights;
  for (int i = 0; i < 300; ++i) lights.add_omni({i, 0, 0}, glm::vec3(float(i)));
  EXPECT_EQ(difference_from_naive(lights), "");
}

int depth_of(const LightTree& tree) {
  std::vector<int> depth(tree.nodes().size(), 0);
  for (std::uint32_t i = 0; i < depth.size(); ++i)
    if (const std::uint32_t child = tree.node(i).first_child; child != 0)
      depth[child] = depth[child + 1] = depth[i] + 1;
  return *std::max_element(depth.begin(), depth.end());
}

TEST(LocallyOrderedClustering, OfCoincidentLightsIsBalanced) {
  LightSet lights;
  for (int i = 0; i < 1000; ++i) lights.add_omni({1, 2, 3}, glm::vec3(1));
  EXPECT_EQ(depth_of(build(lights, {1, Builder::locally_ordered})), 10);
}

} // namespace
} // namespace lightcuts
