// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/scene_features.h>

#include <gtest/gtest.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>

namespace lightcuts {
namespace {

SceneFeatures features_of(const Scene& scene, const CutConfig& config = {}) {
  return find_scene_features(SceneView(scene), build(scene.lights), config);
}

SceneFeatures features_of(const std::string& scene) { return features_of(make_builtin(scene)); }

TEST(SceneFeatures, LeaveTheTreeOutForAFewLights) {
  for (const char* scene : {"cloud?lights=1", "cloud?lights=10", "cloud?lights=100", "desk"})
    EXPECT_FALSE(features_of(scene).tree) << scene;
}

TEST(SceneFeatures, HaveATreeForManyLights) {
  const SceneFeatures features = features_of("cloud?lights=20000");
  EXPECT_TRUE(features.tree);
  EXPECT_LT(features.pilot_cut_size, 2000);
  EXPECT_LT(features.pilot_cost_of_cuts, features.pilot_cost_of_sums);
}

TEST(SceneFeatures, OfTheTreeDependOnTheThreshold) {
  const Scene scene = make_builtin("cloud?lights=5000");
  EXPECT_TRUE(features_of(scene, {0.5F, 1000}).tree);
  EXPECT_FALSE(features_of(scene, {0, 5000}).tree);
}

TEST(SceneFeatures, HaveASpecularBoundForGlossySurfacesOnly) {
  EXPECT_FALSE(features_of("cloud?lights=10&material=diffuse").specular);
  EXPECT_TRUE(features_of("cloud?lights=10&material=glossy").specular);
}

TEST(SceneFeatures, LeaveShadowRaysOutOfAnEmptyRoom) {
  EXPECT_TRUE(features_of("cloud?lights=10&blocks=1").occlusion);
  EXPECT_FALSE(features_of("cloud?lights=10&blocks=0").occlusion);
}

TEST(SceneFeatures, AreTheSameEachTime) {
  const SceneFeatures a = features_of("cloud?lights=500"), b = features_of("cloud?lights=500");
  EXPECT_EQ(a.pilot_cut_size, b.pilot_cut_size);
  EXPECT_EQ(a.pilot_cost_of_cuts, b.pilot_cost_of_cuts);
  EXPECT_EQ(a.pilot_cost_of_sums, b.pilot_cost_of_sums);
  EXPECT_EQ(a.black_level, b.black_level);
}

TEST(SceneFeatures, ScaleTheBlackLevelWithTheLight) {
  Scene scene = make_builtin("cloud?lights=50");
  const SceneFeatures dim = features_of(scene);
  LightSet brighter;
  for (const Light& l : scene.lights) brighter.add_omni(l.position, 16.0F * l.intensity);
  scene.lights = brighter;
  EXPECT_GT(dim.black_level, 0);
  EXPECT_EQ(features_of(scene).black_level, 16 * dim.black_level);
}

TEST(SceneFeatures, OfACameraThatSeesNothingAreFinite) {
  Scene scene = make_builtin("cloud?lights=50");
  scene.camera.position = {0, 1e4F, 0};
  scene.camera.target = {0, 2e4F, 0};
  scene.camera.up = {1, 0, 0};
  const SceneFeatures features = features_of(scene);
  EXPECT_EQ(features.black_level, 0);
  EXPECT_EQ(features.pilot_cut_size, 0);
}

} // namespace
} // namespace lightcuts
