// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/method_choice.h>

#include <gtest/gtest.h>
#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>

namespace lightcuts {
namespace {

MethodChoice choice_for(Scene scene, std::optional<float> threshold = {}) {
  scene.image_size = {80, 60};
  const SceneView view(scene);
  const LightTree tree = build(scene.lights);
  const SceneFeatures features = find_scene_features(
      view, tree, {threshold.value_or(default_threshold(view)), default_max_cut});
  return choose_method(view, tree, features, threshold, {0, default_max_cut, features.black_level});
}

MethodChoice choice_for(const std::string& scene, std::optional<float> threshold = {}) {
  return choice_for(make_builtin(scene), threshold);
}

TEST(ChooseMethod, SharesCutsOfManyLights) {
  for (const char* scene :
       {"cloud?lights=5000", "cloud?lights=5000&blocks=0", "cloud?lights=5000&material=glossy"}) {
    const MethodChoice choice = choice_for(scene);
    EXPECT_EQ(choice.method, methods::block_cuts) << scene;
    EXPECT_LT(choice.cost_of_blocks, choice.cost_of_cuts) << scene;
    EXPECT_GT(choice.block_clusters, 1) << scene;
  }
}

TEST(ChooseMethod, SumsAFewLights) {
  for (const char* scene : {"cloud?lights=1", "cloud?lights=20", "desk"}) {
    const MethodChoice choice = choice_for(scene);
    EXPECT_EQ(choice.method, methods::lightcuts) << scene;
    EXPECT_GT(choice.cost_of_blocks, 0.25) << scene;
  }
}

TEST(ChooseMethod, TakesTheThresholdOfTheMethodOrTheOneGiven) {
  const Scene scene = make_builtin("cloud?lights=5000");
  EXPECT_EQ(choice_for(scene).threshold, default_block_threshold(SceneView(scene)));
  EXPECT_EQ(choice_for(scene, 0.02F).threshold, 0.02F);
  const Scene few = make_builtin("cloud?lights=20");
  EXPECT_EQ(choice_for(few).threshold, default_threshold(SceneView(few)));
  EXPECT_EQ(choice_for(scene, 0.0F).method, methods::lightcuts) << "which sums all lights";
}

TEST(ChooseMethod, ChoosesTheSameEachTime) {
  const MethodChoice a = choice_for("cloud?lights=500"), b = choice_for("cloud?lights=500");
  EXPECT_EQ(a.block_clusters, b.block_clusters);
  EXPECT_EQ(a.block_rays, b.block_rays);
  EXPECT_EQ(a.cost_of_blocks, b.cost_of_blocks);
}

TEST(ChooseMethod, CopesWithNoLightsAndNothingToSee) {
  Scene scene = make_builtin("cloud?lights=500");
  scene.camera.position = {0, 1e4F, 0};
  scene.camera.target = {0, 2e4F, 0};
  scene.camera.up = {1, 0, 0};
  EXPECT_EQ(choice_for(scene).method, methods::lightcuts);
  scene.lights = LightSet();
  EXPECT_EQ(choice_for(scene).method, methods::lightcuts);
}

} // namespace
} // namespace lightcuts
