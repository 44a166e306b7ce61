// SPDX-License-Identifier: MIT
#include <lightcuts/render/renderer.h>

#include <atomic>

#include <gtest/gtest.h>
#include <lightcuts/certified_error.h>
#include <lightcuts/render/builtin_scenes.h>
#include <lightcuts/sum_lights.h>
#include <lightcuts/tree_builder.h>

#include "../../lib/render/src/shapes.h"

namespace lightcuts {
namespace {

/// A room of blocks that fills the picture.
struct Room {
  Scene scene = make_builtin("cloud?lights=300&blocks=5&material=glossy");
  LightTree tree = build(scene.lights);

  Room() { scene.image_size = {37, 21}; }
  [[nodiscard]] Rendering rendered(const RenderConfig& config) const {
    return render(SceneView(scene), tree, config);
  }
};

/// A glowing square of 1 m x 1 m before a wide view of nothing.
Scene square() {
  Scene scene;
  ShapeBuilder builder(scene);
  builder.use("glow", {glm::vec3(0.5F)}, {1, 2, 3});
  builder.quad({-0.5F, -0.5F, 0}, {0.5F, -0.5F, 0}, {0.5F, 0.5F, 0}, {-0.5F, 0.5F, 0});
  scene.lights.add_omni({0, 0, 1}, glm::vec3(1));
  scene.camera = {{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 60};
  scene.image_size = {40, 20};
  return scene;
}

void expect_same_but_for_times(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.certified_error, b.certified_error);
  EXPECT_EQ(a.emission, b.emission);
  EXPECT_EQ(a.cut_size, b.cut_size);
  EXPECT_EQ(a.shadow_rays, b.shadow_rays);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.surface_pixels, b.surface_pixels);
}

TEST(Renderer, GivesTheSameBitsForAnyNumberOfThreads) {
  const Room room;
  for (const Method method : {Method::reference, Method::lightcuts}) {
    const Rendering one = room.rendered({.method = method, .threads = 1});
    for (const unsigned threads : {2U, 3U, 0U})
      expect_same_but_for_times(one, room.rendered({.method = method, .threads = threads}));
  }
}

TEST(Renderer, SumsEveryLightForTheReference) {
  const Room room;
  const Rendering r = room.rendered({.method = Method::reference});
  const SceneView view(room.scene);
  for (unsigned y = 0; y < view.size().y; ++y)
    for (unsigned x = 0; x < view.size().x; ++x) {
      const auto p = view.at({x, y});
      ASSERT_TRUE(p);
      const LightSum sum = sum_lights(room.scene.lights, p->point,
                                      [&](std::uint32_t i) { return view.sees(*p, i); });
      const std::size_t i = y * view.size().x + x;
      EXPECT_EQ(r.radiance[i], glm::vec3(sum.radiance));
      EXPECT_EQ(r.cut_size[i], 300);
      EXPECT_EQ(r.shadow_rays[i], float(sum.shadow_rays));
      EXPECT_EQ(r.certified_error[i].x, certified_error(sum.radiance.x, 0));
    }
}

TEST(Renderer, PicksTheCutOfEachPixel) {
  const Room room;
  const CutConfig config{0.05F, 40, 1e-4F};
  const Rendering r = room.rendered({.cut = config});
  const SceneView view(room.scene);
  CutSelector select(room.tree, config);
  for (unsigned y = 0; y < view.size().y; y += 5)
    for (unsigned x = 0; x < view.size().x; x += 5) {
      const auto p = view.at({x, y});
      const Cut cut = select(p->point, [&](std::uint32_t i) { return view.sees(*p, i); });
      const std::size_t i = y * view.size().x + x;
      EXPECT_EQ(r.radiance[i], cut.radiance);
      EXPECT_EQ(r.certified_error[i], cut.certified_error);
      EXPECT_EQ(r.cut_size[i], float(cut.clusters.size()));
      EXPECT_EQ(r.shadow_rays[i], float(cut.shadow_rays));
      EXPECT_EQ(r.end[i], cut.end);
      EXPECT_EQ(r.emission[i], p->emission);
    }
}

TEST(Renderer, ErrsByNoMoreThanItCertifies) {
  const Room room;
  const Rendering reference = room.rendered({.method = Method::reference});
  const Rendering r = room.rendered({.cut = {0.1F, 100}});
  EXPECT_NE(r.radiance, reference.radiance);
  for (std::size_t i = 0; i < r.radiance.size(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(std::abs(double(r.radiance[i][c]) - reference.radiance[i][c]),
                double(r.certified_error[i][c]) + reference.certified_error[i][c]);
}

TEST(Renderer, SumsLightsWhereTheTreeIsLeftOut) {
  const Room room;
  expect_same_but_for_times(room.rendered({.method = Method::lightcuts, .use_tree = false}),
                            room.rendered({.method = Method::reference}));
}

TEST(Renderer, LeavesPixelsWithoutASurfaceBlack) {
  const Scene scene = square();
  const SceneView view(scene);
  for (const Method method : {Method::reference, Method::lightcuts}) {
    const Rendering r = render(view, build(scene.lights), {.method = method});
    std::uint64_t surface = 0;
    for (unsigned y = 0; y < view.size().y; ++y)
      for (unsigned x = 0; x < view.size().x; ++x) {
        const std::size_t i = y * view.size().x + x;
        if (view.at({x, y})) {
          ++surface;
          EXPECT_EQ(r.emission[i], glm::vec3(1, 2, 3));
          EXPECT_GT(r.radiance[i].x, 0);
          continue;
        }
        for (const auto* v : {&r.radiance, &r.certified_error, &r.emission})
          EXPECT_EQ((*v)[i], glm::vec3(0));
        EXPECT_EQ(r.cut_size[i], 0);
        EXPECT_EQ(r.shadow_rays[i], 0);
      }
    EXPECT_GT(surface, 0U);
    EXPECT_LT(surface, 800U);
    EXPECT_EQ(r.surface_pixels, surface);
  }
}

TEST(Renderer, RendersTheLastRowAndColumn) {
  const Room room;
  const Rendering r = room.rendered({.method = Method::reference});
  EXPECT_EQ(r.size, glm::uvec2(37, 21));
  EXPECT_EQ(r.radiance.size(), 37U * 21U);
  EXPECT_EQ(r.surface_pixels, 37U * 21U);
  EXPECT_EQ(r.cut_size.back(), 300);
}

TEST(Renderer, ReportsProgressUpToTheEnd) {
  const Room room;
  std::atomic<int> calls = 0;
  std::atomic<bool> ended = false;
  RenderConfig config;
  config.progress = [&](double share) {
    ++calls;
    EXPECT_GT(share, 0);
    EXPECT_LE(share, 1);
    if (share == 1) ended = true;
  };
  (void)room.rendered(config);
  EXPECT_GT(calls, 1);
  EXPECT_TRUE(ended);
}

TEST(Renderer, MeasuresTime) {
  const Room room;
  const Rendering r = room.rendered({.method = Method::reference, .threads = 1});
  EXPECT_GT(r.seconds, 0);
  double sum = 0;
  for (const float t : r.microseconds) sum += t;
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, 1e6 * r.seconds);
}

TEST(Method, HasANameThatFindsIt) {
  for (const Method m : {Method::reference, Method::lightcuts})
    EXPECT_EQ(method_named(name_of(m)), m);
  EXPECT_EQ(method_named("Lightcuts"), std::nullopt);
  EXPECT_EQ(method_named(""), std::nullopt);
}

} // namespace
} // namespace lightcuts
