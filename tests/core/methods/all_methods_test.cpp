// SPDX-License-Identifier: MIT
#include <lightcuts/core/methods/all_methods.h>

#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tests/core/blocks/lit_block.h>
#include <tests/support/readme.h>

namespace lightcuts {
namespace {

TEST(AllMethods, AreFoundByNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Method method : all_methods) {
    EXPECT_EQ(method_named(method->name), method);
    names.insert(method->name);
  }
  EXPECT_EQ(names.size(), std::size(all_methods));
  EXPECT_FALSE(method_named("none"));
}

TEST(AllMethods, LightManyPointsAsOneByOneWhereTheyDoNotShare) {
  const LightSet lights = lights_above(50);
  const LightTree tree = build(lights);
  const std::vector<BlockPoint> points = floor_points(3);
  for (const Method method : all_methods) {
    const LighterConfig config{
        .lights = lights, .tree = tree, .cut = {0.1F}, .kinds = lights.kinds()};
    const auto together = method->lighter(config), alone = method->lighter(config);
    std::vector<PixelResult> results(points.size());
    const auto sees = [](std::uint32_t p, std::uint32_t light) { return (p + light) % 3 != 0; };
    together->light_all(points, 7, sees, results);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      const auto sees_it = [&](std::uint32_t light) { return sees(p, light); };
      const PixelResult one = alone->light(points[p].point, 7 + p, sees_it);
      EXPECT_GT(results[p].cut_size, 0) << method->name;
      if (together->shares()) continue;
      EXPECT_EQ(results[p].radiance, one.radiance) << method->name;
      EXPECT_EQ(results[p].shadow_rays, one.shadow_rays) << method->name;
    }
  }
}

TEST(AllMethods, SayWhatTheyMeanInOneSentence) {
  for (const Method method : all_methods) {
    const std::string meaning = method->meaning;
    ASSERT_FALSE(meaning.empty()) << method->name;
    EXPECT_EQ(meaning.find('.'), meaning.size() - 1) << method->name;
  }
}

TEST(AllMethods, StandInTheReadmesTableInTheirOrder) {
  std::string table;
  for (const Method method : all_methods)
    table += fmt::format("| `{}` | {} |\n", method->name, method->meaning);
  EXPECT_NE(test::readme().find("|---|---|\n" + table + "\n"), std::string::npos)
      << "README.md should have:\n"
      << table;
}

} // namespace
} // namespace lightcuts
