// SPDX-License-Identifier: MIT
#include <viz/model/picture/frame.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::Each;

/// The library's own picture with all settings by hand.
Rendering rendered(Method method, std::uint64_t seed, const Camera& camera) {
  const OpenedScene& scene = *small_scene();
  RenderConfig config;
  config.method = method;
  config.cut = {0.1F, default_max_cut, scene.black_level()};
  config.seed = seed;
  return render(scene.view().seen_by(camera, {32, 24}), *scene.tree(), config);
}

void expect_same(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.certified_error, b.certified_error);
  EXPECT_EQ(a.emission, b.emission);
  EXPECT_EQ(a.cut_size, b.cut_size);
  EXPECT_EQ(a.shadow_rays, b.shadow_rays);
  EXPECT_EQ(a.end, b.end);
}

TEST(Frame, IsTheLibrarysPictureByEveryMethod) {
  for (const Method method : all_methods) {
    SCOPED_TRACE(method->name);
    ShadingSettings settings = always_cuts();
    settings.seed = 5;
    const auto frame = made<Frame>(small_key(method, settings));
    EXPECT_TRUE(frame->complete());
    EXPECT_EQ(frame->failure(), "");
    expect_same(frame->rendering(), rendered(method, 5, frame->key().camera));
  }
}

TEST(Frame, IsTheSamePictureHoweverOftenItIsCancelled) {
  Frame frame(small_key(methods::stochastic));
  for (int round = 0; !frame.complete(); ++round) {
    std::atomic<int> asked = 0;
    frame.advance(Progress::until([&] { return ++asked > 90 + round; }));
    ASSERT_LT(round, 1000);
  }
  expect_same(frame.rendering(), rendered(methods::stochastic, 1, frame.key().camera));
}

TEST(Frame, IsSeenByItsOwnCamera) {
  FrameKey key = small_key();
  key.camera.position += glm::vec3(0.3F, 0.2F, 0);
  key.camera.vertical_fov = 30;
  const auto frame = made<Frame>(key);
  expect_same(frame->rendering(), rendered(methods::lightcuts, 1, key.camera));
  EXPECT_NE(frame->rendering().radiance, made<Frame>(small_key())->rendering().radiance);
}

TEST(Frame, IsByTheRulesThatAreChosen) {
  ShadingSettings settings = always_cuts();
  settings.rules.bound = BoundRule::product;
  settings.rules.estimate = EstimateRule::representative;
  const auto frame = made<Frame>(small_key(methods::lightcuts, settings));
  expect_same(frame->rendering(), rendered(methods::paper, 1, frame->key().camera));
}

TEST(Frame, HasTheThresholdAndLargestCutThatAreChosen) {
  ShadingSettings settings = always_cuts();
  settings.threshold = 0;
  settings.max_cut = 7;
  const auto frame = made<Frame>(small_key(methods::lightcuts, settings));
  EXPECT_EQ(frame->cut().threshold, 0);
  EXPECT_THAT(frame->rendering().cut_size, Each(testing::AnyOf(0, 7)));
  settings.threshold.reset();
  EXPECT_EQ(Frame(small_key(methods::lightcuts, settings)).cut().threshold,
            default_threshold(small_scene()->view()));
}

TEST(Frame, SumsAllLightsWhereTheTreeDoesNotPay) {
  ShadingSettings settings;
  settings.threshold = 0.001F;
  Frame frame(small_key(methods::lightcuts, settings));
  EXPECT_FALSE(frame.features()) << "nothing is known before it has begun";
  EXPECT_FALSE(frame.sums_all_lights());
  frame.advance();
  const OpenedScene& scene = *small_scene();
  const SceneFeatures expected = find_scene_features(scene.view(), *scene.tree(), frame.cut());
  ASSERT_TRUE(frame.features());
  EXPECT_FALSE(expected.tree) << "or this test says nothing";
  EXPECT_EQ(frame.features()->tree, expected.tree);
  EXPECT_EQ(frame.features()->pilot_cut_size, expected.pilot_cut_size);
  EXPECT_TRUE(frame.sums_all_lights());
  EXPECT_EQ(frame.rendering().radiance,
            made<Frame>(small_key(methods::reference))->rendering().radiance);
}

TEST(Frame, AsksWhetherTheTreePaysOnlyWhereThatMatters) {
  EXPECT_FALSE(made<Frame>(small_key())->features()) << "always cuts";
  EXPECT_FALSE(made<Frame>(small_key())->sums_all_lights());
  const auto reference = made<Frame>(small_key(methods::reference, {}));
  EXPECT_FALSE(reference->features());
  EXPECT_TRUE(reference->sums_all_lights());
  EXPECT_FALSE(made<Frame>(small_key(methods::paper, {}))->features());
}

} // namespace
} // namespace lightcuts::viz
