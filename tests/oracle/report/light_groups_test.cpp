// SPDX-License-Identifier: MIT
#include <oracle/report/light_groups.h>

#include <gtest/gtest.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <oracle/report/image_error.h>
#include <oracle/report/plots/pictures.h>

namespace lightcuts::oracle {
namespace {

Scene grouped_cloud_scene() {
  Scene scene = make_builtin("cloud?lights=60&blocks=4");
  scene.image_size = {24, 18};
  scene.groups = {{"a", 0, 10}, {"b", 20, 15}, {"a", 35, 5}};
  return scene;
}

/// All lights at once, and the groups by themselves.
struct GroupedCloud {
  Scene scene = grouped_cloud_scene();
  SceneView view{scene};
  Rendering whole;
  std::vector<GroupPicture> groups;

  explicit GroupedCloud(Method of_whole) {
    RenderConfig config;
    config.method = of_whole;
    whole = render(view, build(scene.lights), config);
    config.method = methods::lightcuts;
    groups = render_groups(view, config, {});
  }
};

TEST(LightGroups, HaveEachLightOnce) {
  const Scene scene = grouped_cloud_scene();
  const auto groups = lights_by_group(scene);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].first, "a");
  EXPECT_EQ(groups[0].second.size(), 15U);
  EXPECT_EQ(groups[0].second[10], scene.lights[35]);
  EXPECT_EQ(groups[1].first, "b");
  EXPECT_EQ(groups[1].second.size(), 15U);
  EXPECT_EQ(groups[2].first, "others");
  EXPECT_EQ(groups[2].second.size(), 30U);
  EXPECT_TRUE(lights_by_group(make_builtin("desk")).empty());
}

// What each group is off by, at most, sums to what their sum is.
TEST(LightGroups, SumToThePicture) {
  const GroupedCloud cloud(methods::reference);
  const auto& whole = cloud.whole;
  const auto& groups = cloud.groups;
  ASSERT_EQ(groups.size(), 3U);
  bool any = false;
  for (std::size_t i = 0; i < whole.radiance.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      double sum = 0, certified = whole.certified_error[i][c];
      for (const GroupPicture& group : groups) {
        sum += group.rendering.radiance[i][c];
        certified += group.rendering.certified_error[i][c];
      }
      any = any || sum > 0;
      EXPECT_LE(std::abs(sum - whole.radiance[i][c]), certified);
    }
  EXPECT_TRUE(any);
}

TEST(LightGroups, AreLayersOfTheFilm) {
  const GroupedCloud cloud(methods::lightcuts);
  const auto& groups = cloud.groups;
  const Film film = film_of({cloud.whole, nullptr, 0, "cloud", 1, 0.02F, groups});
  for (const GroupPicture& group : groups) {
    const std::string prefix = "group." + group.name + ".";
    double light = 0, bound = 0;
    for (const char* channel : {"R", "G", "B"})
      for (const float v : film.channel(prefix + channel)) light += v;
    for (const float v : film.channel(prefix + "bound")) bound += v;
    EXPECT_NEAR(light, group.light(), 1e-9 * light);
    EXPECT_GT(light, 0);
    EXPECT_NEAR(bound, group.certified_error(), 1e-6 * bound);
  }
  EXPECT_EQ(film_of({cloud.whole}).channel_names().size() + 3 * 4, film.channel_names().size());
}

} // namespace
} // namespace lightcuts::oracle
