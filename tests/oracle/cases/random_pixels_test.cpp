// SPDX-License-Identifier: MIT
#include <oracle/cases/random_pixels.h>

#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <tests/oracle/support/small_scene.h>

namespace lightcuts::oracle {
namespace {

using Place = std::pair<float, float>;

Place place_of(const VisiblePoint& p) { return {p.point.position().x, p.point.position().z}; }

TEST(RandomPoint, IsTheSameForTheSameArguments) {
  const Scene scene = floor_scene(1);
  const SceneView view(scene);
  for (std::uint64_t i = 0; i < 20; ++i)
    EXPECT_EQ(place_of(random_point(view, 3, i)), place_of(random_point(view, 3, i)));
}

// 192 pixels, each missed by 2000 draws with a probability of 3e-5.
TEST(RandomPoint, ComesToEveryPixelThatSeesASurface) {
  const Scene scene = floor_scene(1);
  const SceneView view(scene);
  std::set<Place> all, drawn;
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x)
      if (const auto p = view.at({x, y})) all.insert(place_of(*p));
  for (std::uint64_t i = 0; i < 2000; ++i) drawn.insert(place_of(random_point(view, 1, i)));
  EXPECT_EQ(all.size(), 192U);
  EXPECT_EQ(drawn, all);
}

TEST(RandomPoint, DependsOnSeedAndIndex) {
  const Scene scene = floor_scene(1);
  const SceneView view(scene);
  int same_seed = 0, same_index = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    same_seed += place_of(random_point(view, 1, i)) == place_of(random_point(view, 1, i + 1));
    same_index += place_of(random_point(view, 1, i)) == place_of(random_point(view, 2, i));
  }
  // 200 / 192 are expected; 10 or more have a probability of 1e-7.
  EXPECT_LT(same_seed, 10);
  EXPECT_LT(same_index, 10);
}

TEST(RandomPoint, FindsTheOnlyPixelThatSeesASurface) {
  Scene scene = floor_scene(1);
  scene.mesh.positions.clear();
  scene.mesh.normals.clear();
  scene.mesh.triangles.clear();
  scene.mesh.surface.clear();
  add_level_square(scene, 0.12F, 0);
  const SceneView view(scene);
  int seen = 0;
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x) seen += view.at({x, y}) ? 1 : 0;
  ASSERT_GT(seen, 0);
  ASSERT_LT(seen, 20);
  for (std::uint64_t i = 0; i < 50; ++i)
    EXPECT_LE(std::abs(random_point(view, 1, i).point.position().x), 0.12F);
}

TEST(RandomPoint, RefusesAViewOfNothing) {
  Scene scene = floor_scene(1);
  scene.camera.target = {0, 6, 0.5F};
  scene.camera.up = {1, 0, 0};
  EXPECT_THROW((void)random_point(SceneView(scene), 1, 0), InputError);
}

} // namespace
} // namespace lightcuts::oracle
