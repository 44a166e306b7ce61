// SPDX-License-Identifier: MIT
#include <lightcuts/render/needs.h>

#include <gtest/gtest.h>
#include <lightcuts/render/builtin_scenes.h>
#include <lightcuts/tree_builder.h>

namespace lightcuts {
namespace {

Needs needs_of(const Scene& scene, const CutConfig& config = {}) {
  return find_needs(SceneView(scene), build(scene.lights), config);
}

Needs needs_of(const std::string& scene) { return needs_of(make_builtin(scene)); }

TEST(Needs, LeaveTheTreeOutForAFewLights) {
  for (const char* scene : {"cloud?lights=1", "cloud?lights=10", "cloud?lights=100", "desk"})
    EXPECT_FALSE(needs_of(scene).tree) << scene;
}

TEST(Needs, HaveATreeForManyLights) {
  const Needs needs = needs_of("cloud?lights=20000");
  EXPECT_TRUE(needs.tree);
  EXPECT_LT(needs.pilot_cut_size, 2000);
  EXPECT_LT(needs.pilot_cost_of_cuts, needs.pilot_cost_of_sums);
}

TEST(Needs, OfTheTreeDependOnTheThreshold) {
  const Scene scene = make_builtin("cloud?lights=5000");
  EXPECT_TRUE(needs_of(scene, {0.5F, 1000}).tree);
  EXPECT_FALSE(needs_of(scene, {0, 5000}).tree);
}

TEST(Needs, HaveASpecularBoundForGlossySurfacesOnly) {
  EXPECT_FALSE(needs_of("cloud?lights=10&material=diffuse").specular);
  EXPECT_TRUE(needs_of("cloud?lights=10&material=glossy").specular);
}

TEST(Needs, LeaveShadowRaysOutOfAnEmptyRoom) {
  EXPECT_TRUE(needs_of("cloud?lights=10&blocks=1").occlusion);
  EXPECT_FALSE(needs_of("cloud?lights=10&blocks=0").occlusion);
}

TEST(Needs, AreTheSameEachTime) {
  const Needs a = needs_of("cloud?lights=500"), b = needs_of("cloud?lights=500");
  EXPECT_EQ(a.pilot_cut_size, b.pilot_cut_size);
  EXPECT_EQ(a.pilot_cost_of_cuts, b.pilot_cost_of_cuts);
  EXPECT_EQ(a.pilot_cost_of_sums, b.pilot_cost_of_sums);
  EXPECT_EQ(a.black_level, b.black_level);
}

TEST(Needs, ScaleTheBlackLevelWithTheLight) {
  Scene scene = make_builtin("cloud?lights=50");
  const Needs dim = needs_of(scene);
  LightSet brighter;
  for (const Light& l : scene.lights) brighter.add_omni(l.position, 16.0F * l.intensity);
  scene.lights = brighter;
  EXPECT_GT(dim.black_level, 0);
  EXPECT_EQ(needs_of(scene).black_level, 16 * dim.black_level);
}

TEST(Needs, OfACameraThatSeesNothingAreFinite) {
  Scene scene = make_builtin("cloud?lights=50");
  scene.camera.position = {0, 1e4F, 0};
  scene.camera.target = {0, 2e4F, 0};
  scene.camera.up = {1, 0, 0};
  const Needs needs = needs_of(scene);
  EXPECT_EQ(needs.black_level, 0);
  EXPECT_EQ(needs.pilot_cut_size, 0);
}

} // namespace
} // namespace lightcuts
