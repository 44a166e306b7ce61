// SPDX-License-Identifier: MIT
#include <oracle/campaign/check.h>

#include <array>
#include <iostream>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lightcuts/render/builtin/builtin_scenes.h>
#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {
namespace {

// Every kind of light, every lobe, with and without something that occludes, clamped or not.
constexpr std::array campaign_kinds{"omni", "oriented", "spot", "directional", "profile", "mixed"};
constexpr std::array campaign_materials{"diffuse", "phong", "ward", "ggx"};
constexpr std::array rooms{"&blocks=0", "&blocks=20", "&blocks=0&clamp=0.5",
                           "&blocks=20&clamp=0.5"};

constexpr std::uint64_t pairs_of_scene = 1'062'500;
constexpr std::size_t scene_count =
    campaign_kinds.size() * campaign_materials.size() * rooms.size();
static_assert(scene_count * pairs_of_scene >= 100'000'000);

using Combination = std::tuple<const char*, const char*>;

/// (node, point) pairs by the hundred million. One process has four scenes: starting one takes
/// long.
class Campaign : public testing::TestWithParam<Combination> {};

TEST_P(Campaign, FindsNoViolation) {
  const auto [kind, material] = GetParam();
  std::uint64_t pairs = 0;
  for (const char* room : rooms) {
    const std::string spec =
        fmt::format("cloud?lights=2000&kind={}&material={}{}", kind, material, room);
    SCOPED_TRACE(spec);
    const Scene scene = make_builtin(spec);
    const SceneView view(scene);
    const CheckResult result =
        check(view, *library_subject(), {.pairs = pairs_of_scene, .threads = 1});
    for (const Property p : all_properties) {
      const PropertyCount& count = result.tally[p];
      EXPECT_EQ(count.violations, 0U) << info(p).name << ": " << count.first_violation;
    }
    for (const Property p : reached_by_check) EXPECT_GT(result.tally[p].cases, 0U) << info(p).name;
    EXPECT_GE(result.pairs, pairs_of_scene);
    pairs += result.pairs;
  }
  RecordProperty("pairs", std::to_string(pairs));
  std::cout << fmt::format("{} (node, point) pairs compared, of at least {} in all {} scenes\n",
                           pairs, scene_count * pairs_of_scene, scene_count);
}

INSTANTIATE_TEST_SUITE_P(Cloud, Campaign,
                         testing::Combine(testing::ValuesIn(campaign_kinds),
                                          testing::ValuesIn(campaign_materials)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param)) + "_" +
                                  std::get<1>(tested.param);
                         });

TEST(LocallyOrderedCampaign, FindsNothingButTreesThatCostMore) {
  const Scene scene = make_builtin("cloud?lights=2000&kind=mixed&material=ggx&blocks=20");
  const CheckResult result =
      check(SceneView(scene), *locally_ordered_subject(), {.pairs = pairs_of_scene, .threads = 1});
  for (const Property p : all_properties) {
    if (p == Property::tree_equals_naive) continue;
    const PropertyCount& count = result.tally[p];
    EXPECT_EQ(count.violations, 0U) << info(p).name << ": " << count.first_violation;
  }
  EXPECT_GE(result.pairs, pairs_of_scene);
}

} // namespace
} // namespace lightcuts::oracle
