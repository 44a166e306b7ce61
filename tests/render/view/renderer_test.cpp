// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/renderer.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <string_view>
#include <tuple>

#include <gtest/gtest.h>
#include <lightcuts/core/cut/certified_error.h>
#include <lightcuts/core/cut/stochastic_cut.h>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/builtin/builtin_scenes.h>

#include <lightcuts/render/builtin/shapes.h>

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
  for (const Method method : all_methods) {
    const Rendering one = room.rendered({.method = method, .threads = 1});
    for (const unsigned threads : {2U, 3U, 0U})
      expect_same_but_for_times(one, room.rendered({.method = method, .threads = threads}));
  }
}

TEST(Renderer, SumsEveryLightForTheReference) {
  const Room room;
  const Rendering r = room.rendered({.method = methods::reference});
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
  const Rendering reference = room.rendered({.method = methods::reference});
  for (const Method method : all_methods) {
    if (method == methods::reference) continue;
    const Rendering r = room.rendered({.method = method, .cut = {0.1F, 100}});
    EXPECT_NE(r.radiance, reference.radiance);
    for (std::size_t i = 0; i < r.radiance.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(double(r.radiance[i][c]) - reference.radiance[i][c]),
                  double(r.certified_error[i][c]) + reference.certified_error[i][c]);
  }
}

TEST(Renderer, DrawsTheLightsOfEachPixelByTheSeed) {
  const Room room;
  const CutConfig config{0.1F, 40, 1e-4F};
  const Rendering r = room.rendered({.method = methods::stochastic, .cut = config, .seed = 5});
  const SceneView view(room.scene);
  StochasticCutSelector select(room.tree, config, 5);
  for (unsigned y = 0; y < view.size().y; y += 5)
    for (unsigned x = 0; x < view.size().x; x += 5) {
      const auto p = view.at({x, y});
      const std::size_t i = y * view.size().x + x;
      const Cut cut = select(p->point, i, [&](std::uint32_t j) { return view.sees(*p, j); });
      EXPECT_EQ(r.radiance[i], cut.radiance);
      EXPECT_EQ(r.certified_error[i], cut.certified_error);
      EXPECT_EQ(r.shadow_rays[i], float(cut.shadow_rays));
    }
  EXPECT_NE(r.radiance, room.rendered({.method = methods::stochastic, .cut = config}).radiance);
}

double mean(const std::vector<glm::vec3>& picture) {
  double sum = 0;
  for (const glm::vec3& v : picture) sum += double(v.x) + v.y + v.z;
  return sum / (3 * double(picture.size()));
}

double rmse(const std::vector<glm::dvec3>& a, const std::vector<glm::vec3>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 d = a[i] - glm::dvec3(b[i]);
    squares += glm::dot(d, d);
  }
  return std::sqrt(squares / (3 * double(a.size())));
}

// The error of the mean of n falls like that of independent samples, whatever the pixel; what is
// left of a bias would not fall.
TEST(Renderer, ConvergesToTheReferenceByTheMeanOverSeeds) {
  const Room room;
  const Rendering reference = room.rendered({.method = methods::reference});
  for (const Method method :
       std::initializer_list<Method>{methods::stochastic, methods::stochastic_intensity}) {
    constexpr int n = 64;
    std::vector<glm::dvec3> sum(reference.radiance.size(), glm::dvec3(0));
    double of_one = 0, brightness = 0, brightness2 = 0;
    for (std::uint64_t seed = 0; seed < n; ++seed) {
      const Rendering r = room.rendered({.method = method, .cut = {0.2F, 20}, .seed = seed});
      const std::vector<glm::dvec3> picture(r.radiance.begin(), r.radiance.end());
      of_one += std::pow(rmse(picture, reference.radiance), 2) / n;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += picture[i] / double(n);
      const double d = mean(r.radiance) - mean(reference.radiance);
      brightness += d / n;
      brightness2 += d * d / n;
    }
    // Of 777 pixels: the mean square has a deviation of about sqrt(2 / 777), half of it the root.
    EXPECT_NEAR(rmse(sum, reference.radiance) * std::sqrt(n / of_one), 1, 0.15) << method->name;
    EXPECT_LE(std::abs(brightness), 5 * std::sqrt(brightness2 / n)) << method->name;
  }
}

TEST(Renderer, IsTooDarkWithoutScaling) {
  const Room room;
  const RenderConfig config{.method = methods::unscaled, .cut = {0.5F, 100}};
  const Rendering r = room.rendered(config);
  EXPECT_LT(mean(r.radiance), 0.9 * mean(room.rendered({.method = methods::reference}).radiance));
}

TEST(Renderer, SumsLightsWhereTheTreeIsLeftOut) {
  const Room room;
  expect_same_but_for_times(room.rendered({.method = methods::lightcuts, .use_tree = false}),
                            room.rendered({.method = methods::reference}));
}

TEST(Renderer, LeavesPixelsWithoutASurfaceBlack) {
  const Scene scene = square();
  const SceneView view(scene);
  for (const Method method :
       std::initializer_list<Method>{methods::reference, methods::lightcuts}) {
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
  const Rendering r = room.rendered({.method = methods::reference});
  EXPECT_EQ(r.size, glm::uvec2(37, 21));
  EXPECT_EQ(r.radiance.size(), 37U * 21U);
  EXPECT_EQ(r.surface_pixels, 37U * 21U);
  EXPECT_EQ(r.cut_size.back(), 300);
}

TEST(Renderer, RendersWantedPixelsIntoAPicture) {
  const Room room;
  const SceneView view(room.scene);
  const Rendering whole = room.rendered({});
  const auto coarse = [](glm::uvec2 p) { return p.x % 4 == 0 && p.y % 4 == 0; };
  Rendering picture = blank_rendering(view.size());
  render_into(picture, view, room.tree, {}, coarse);
  EXPECT_EQ(picture.surface_pixels, 10U * 6U);
  for (unsigned y = 0; y < 21; ++y)
    for (unsigned x = 0; x < 37; ++x) {
      const std::size_t i = y * 37 + x;
      EXPECT_EQ(picture.radiance[i], coarse({x, y}) ? whole.radiance[i] : glm::vec3(0));
    }
  const double seconds = picture.seconds;
  render_into(picture, view, room.tree, {}, [&](glm::uvec2 p) { return !coarse(p); });
  expect_same_but_for_times(picture, whole);
  EXPECT_GT(picture.seconds, seconds);
}

TEST(Renderer, TellsOfEachWantedPixelOnce) {
  const Room room;
  const SceneView view(room.scene);
  std::mutex mutex;
  std::vector<int> told(37 * 21);
  RenderConfig config;
  config.done = [&](const PixelRect& rect) {
    const std::lock_guard lock(mutex);
    for (unsigned y = rect.lo.y; y < rect.hi.y; ++y)
      for (unsigned x = rect.lo.x; x < rect.hi.x; ++x) ++told[y * 37 + x];
  };
  Rendering picture = blank_rendering(view.size());
  render_into(picture, view, room.tree, config, [](glm::uvec2 p) { return p.y != 3; });
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], i / 37 == 3 ? 0 : 1) << i;
}

TEST(Renderer, LeavesPixelsWhenCancelled) {
  const Room room;
  std::atomic<int> asked = 0;
  const Rendering r =
      room.rendered({.threads = 1, .progress = Progress::until([&] { return ++asked > 40; })});
  EXPECT_EQ(r.surface_pixels, 40U);
}

TEST(Renderer, LightsByTheRulesChosen) {
  const Room room;
  for (const auto& [method, bound, estimate] :
       {std::tuple(Method(methods::paper), BoundRule::product, EstimateRule::representative),
        std::tuple(Method(methods::unscaled), BoundRule::product, EstimateRule::unscaled),
        std::tuple(Method(methods::no_specular_bound), BoundRule::no_specular,
                   EstimateRule::centroid)}) {
    RenderConfig by_choice{.cut = {0.02F, 200}, .rules = ClusterRules()};
    by_choice.rules->bound = bound;
    by_choice.rules->estimate = estimate;
    const Rendering expected = room.rendered({.method = method, .cut = {0.02F, 200}});
    EXPECT_NE(expected.radiance, room.rendered({.cut = {0.02F, 200}}).radiance);
    expect_same_but_for_times(room.rendered(by_choice), expected);
  }
}

TEST(Renderer, ReportsProgressUpToTheEnd) {
  const Room room;
  std::atomic<int> calls = 0;
  std::atomic<bool> ended = false;
  RenderConfig config;
  config.progress = Progress([&](double share) {
    ++calls;
    EXPECT_GT(share, 0);
    EXPECT_LE(share, 1);
    if (share == 1) ended = true;
  });
  (void)room.rendered(config);
  EXPECT_GT(calls, 1);
  EXPECT_TRUE(ended);
}

TEST(Renderer, MeasuresTime) {
  const Room room;
  const Rendering r = room.rendered({.method = methods::reference, .threads = 1});
  EXPECT_GT(r.seconds, 0);
  double sum = 0;
  for (const float t : r.microseconds) sum += t;
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, 1e6 * r.seconds);
}

TEST(Method, HasANameThatFindsIt) {
  for (const Method m : all_methods) {
    EXPECT_NE(std::string_view(m->name), "");
    EXPECT_EQ(method_named(m->name), m);
  }
  EXPECT_EQ(method_named("stochastic"), methods::stochastic);
  EXPECT_EQ(method_named("stochastic-intensity"), methods::stochastic_intensity);
  EXPECT_EQ(method_named("unscaled"), methods::unscaled);
  EXPECT_EQ(method_named("Lightcuts"), std::nullopt);
  EXPECT_EQ(method_named(""), std::nullopt);
}

} // namespace
} // namespace lightcuts
