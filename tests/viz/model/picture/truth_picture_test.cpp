// SPDX-License-Identifier: MIT
#include <viz/model/picture/truth_picture.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/methods/paper.h>
#include <oracle/subjects/library_subject.h>
#include <oracle/truth/clairvoyant.h>

#include <tests/viz/support/counterexample_file.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::Each;

/// Of the pixel, by the oracle, all by hand; 0 where no surface is seen.
std::size_t clairvoyant_at(const FrameKey& key, oracle::SubjectTree& tree, glm::uvec2 pixel) {
  const OpenedScene& scene = *key.scene;
  const SceneView view = scene.view().seen_by(key.camera, scene.scene().image_size);
  const auto p = view.at(pixel);
  if (!p) return 0;
  const LightSet& lights = scene.scene().lights;
  std::vector<char> visible;
  for (std::uint32_t i = 0; i < lights.size(); ++i) visible.push_back(view.casts_to(*p, i) ? 1 : 0);
  const auto reading = oracle::read_topology(tree.claim(), lights.size());
  oracle::Truth truth;
  truth.evaluate(*reading.topology, lights, p->point, visible);
  const oracle::Judged judged{tree, oracle::only(oracle::Part::bounds) |
                                        oracle::only(oracle::Part::estimates)};
  const oracle::PointCase at{0, p->point, visible, truth};
  const auto estimate = [&](std::uint32_t node) { return seen_estimate(judged, node, at); };
  return clairvoyant_cut_size(truth, estimate, *key.settings.threshold, scene.black_level());
}

void expect_clairvoyant(const FrameKey& key, oracle::SubjectTree& tree) {
  const auto picture = made<TruthPicture>(key);
  for (unsigned y = 0; y < 24; y += 3)
    for (unsigned x = 0; x < 32; x += 3)
      ASSERT_EQ(picture->clairvoyant()[std::size_t(y) * 32 + x],
                float(clairvoyant_at(key, tree, {x, y})))
          << x << ", " << y;
}

TEST(TruthPicture, HasTheOraclesClairvoyantCuts) {
  oracle::LibraryTree library(*small_scene()->tree());
  expect_clairvoyant(small_key(), library);
  oracle::LibraryTree paper(*small_scene()->tree(),
                            oracle::library_kernel(all_light_kinds, methods::paper.rules));
  expect_clairvoyant(small_key(methods::paper), paper);
}

TEST(TruthPicture, HasACutWhereverASurfaceIsSeenAndNothingElsewhere) {
  FrameKey key = small_key();
  key.camera.position *= 4; // from outside, over the room's edge
  key.camera.vertical_fov = 90;
  const auto picture = made<TruthPicture>(key);
  const SceneView view = key.scene->view().seen_by(key.camera, {32, 24});
  std::size_t surfaces = 0;
  for (unsigned i = 0; i < 32 * 24; ++i) {
    const bool surface = view.at({i % 32, i / 32}).has_value();
    EXPECT_EQ(picture->clairvoyant()[i] > 0, surface);
    surfaces += surface ? 1 : 0;
  }
  EXPECT_GT(surfaces, 0U);
  EXPECT_LT(surfaces, 32U * 24U);
}

TEST(TruthPicture, FindsNothingWrongWithTheLibraryByAnyMethod) {
  for (const Method method : all_methods) {
    const auto picture = made<TruthPicture>(small_key(method));
    EXPECT_EQ(picture->failure(), "");
    EXPECT_THAT(picture->violations(), Each(0)) << method->name;
  }
}

TEST(TruthPicture, IsTheSameHoweverOftenItIsCancelled) {
  const auto whole = made<TruthPicture>(small_key());
  TruthPicture picture(small_key());
  while (!picture.complete()) {
    std::atomic<int> asked = 0;
    picture.advance(Progress::until([&] { return ++asked > 100; }));
  }
  EXPECT_EQ(picture.clairvoyant(), whole->clairvoyant());
  EXPECT_EQ(picture.violations(), whole->violations());
}

TEST(TruthPicture, FindsWhatIsWrongWithTheSubjectOfACounterexample) {
  const CounterexampleFile file(broken_bound, counterexample_of(broken_bound));
  const auto scene = file.open();
  const auto picture = begun<TruthPicture>({scene, methods::lightcuts, {}, scene->scene().camera});
  EXPECT_EQ(picture->failure(), "");
  const auto& violations = picture->violations();
  EXPECT_GT(*std::max_element(violations.begin(), violations.end()), 0);
}

} // namespace
} // namespace lightcuts::viz
