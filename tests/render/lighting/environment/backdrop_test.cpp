// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/environment/backdrop.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/kinds/light_kinds.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/lighting/environment/environment_lights.h>
#include <lightcuts/render/view/renderer.h>

#include <tests/render/support/box_scene.h>

namespace lightcuts {
namespace {

EnvironmentMap numbered(glm::uvec2 size) {
  EnvironmentMap map{"sky", size, {}, {}};
  for (std::size_t i = 0; i < std::size_t{size.x} * size.y; ++i)
    map.radiance.emplace_back(float(i));
  return map;
}

/// The documented direction of a place in a map turned by so many degrees, in pixels.
glm::vec3 direction(const EnvironmentMap& map, double x, double y, double turn) {
  const double polar = std::numbers::pi * y / map.size.y;
  const double longitude = std::numbers::pi * (1 - 2 * x / map.size.x + turn / 180);
  return {std::sin(polar) * std::sin(longitude), std::cos(polar),
          std::sin(polar) * std::cos(longitude)};
}

TEST(Backdrop, HasThePixelThatADirectionPassesThrough) {
  for (const glm::uvec2 size : {glm::uvec2(1, 1), {2, 1}, {3, 2}, {1, 5}, {64, 32}, {7, 9}})
    for (const double turn : {0.0, 90.0, -360.0, 12.34, 359.0}) {
      const EnvironmentMap map = numbered(size);
      const Backdrop backdrop(map, turn);
      for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x)
          for (const glm::dvec2 at : {glm::dvec2(0.5, 0.5), {0.01, 0.02}, {0.99, 0.98}}) {
            const glm::vec3 d = direction(map, x + at.x, y + at.y, turn);
            EXPECT_EQ(backdrop.radiance(3.0F * d).x, float(y * size.x + x))
                << size.x << " x " << size.y << ", pixel " << x << ", " << y << ", turn " << turn;
          }
    }
}

TEST(Backdrop, HasAPixelInEveryDirection) {
  const Backdrop backdrop(numbered({4, 2}), 0);
  for (const glm::vec3& d :
       {glm::vec3(0, 1, 0), {0, -1, 0}, {0, 0, -1}, {1e-30F, 0, -1}, {-1, 0, 0}})
    EXPECT_LT(backdrop.radiance(d).x, 8);
}

/// One bright pixel, in a map turned so that it comes from there.
struct OneStar {
  EnvironmentMap map{"star", {16, 8}, std::vector<glm::vec3>(128, glm::vec3(0)), {}};
  static constexpr unsigned x = 3, y = 2;

  OneStar() { map.radiance[y * 16 + x] = {4, 5, 6}; }
};

TEST(Backdrop, IsTurnedAsItsLightsAre) {
  for (const double turn : {0.0, 90.0, -45.0, 200.0}) {
    const OneStar star;
    Scene scene;
    add_environment_lights(scene, star.map, {.turn = turn, .visible = true, .count = 4});
    ASSERT_EQ(scene.lights.size(), 1U);
    const glm::vec3 towards = scene.lights[0].position;
    EXPECT_LT(glm::distance(towards, direction(star.map, star.x + 0.5, star.y + 0.5, turn)), 1e-6F);
    ASSERT_EQ(scene.backdrops.size(), 1U);
    EXPECT_EQ(scene.backdrops[0]->radiance(towards), glm::vec3(4, 5, 6));
    EXPECT_EQ(scene.backdrops[0]->radiance(-towards), glm::vec3(0));
  }
}

// What was along +z lies along +x after a quarter turn.
TEST(Backdrop, TurnsFromZTowardsX) {
  EnvironmentMap map{"sky", {3, 1}, {glm::vec3(0), glm::vec3(1), glm::vec3(0)}, {}};
  Scene scene;
  add_environment_lights(scene, map, {.turn = 90, .count = 1});
  EXPECT_LT(glm::distance(scene.lights[0].position, glm::vec3(1, 0, 0)), 1e-6F);
  EXPECT_TRUE(scene.backdrops.empty()) << "not visible by default";
}

TEST(Backdrop, RefusesATurnThatIsNone) {
  Scene scene;
  for (const double bad : {361.0, -1e9, std::nan("")})
    EXPECT_THROW(add_environment_lights(scene, numbered({2, 1}), {.turn = bad}), InputError);
  EXPECT_TRUE(scene.lights.empty());
}

/// A triangle in a corner of the picture, under a star that the camera looks at.
Scene starlit(bool visible) {
  Scene scene;
  scene.mesh = {{{-1, -1, 0}, {0, -1, 0}, {-1, 0, 0}}, {}, {}, {}, {}, {{0, 1, 2}}, {0}};
  scene.mesh.normals.assign(3, glm::vec3(0));
  scene.surfaces.push_back({"grey", {glm::vec3(0.5F), {}}});
  scene.image_size = {24, 24};
  const OneStar star;
  add_environment_lights(scene, star.map, {.visible = visible, .count = 4});
  const glm::vec3 towards = scene.lights[0].position;
  scene.camera = {2.0F * -towards, {0, 0, 0}, {0, 1, 0}, 60};
  return scene;
}

void expect_beyond(const Method& method) {
  for (const bool visible : {false, true}) {
    const Scene scene = starlit(visible);
    const SceneView view(scene);
    const LightTree tree = build(scene.lights);
    const Rendering r = render(view, tree, {.method = method});
    int lit = 0, surface = 0;
    for (unsigned y = 0; y < 24; ++y)
      for (unsigned x = 0; x < 24; ++x) {
        const std::size_t i = y * 24 + x;
        const bool on_surface = view.at({x, y}).has_value();
        surface += on_surface;
        if (on_surface) {
          EXPECT_EQ(r.emission[i], glm::vec3(0));
          continue;
        }
        EXPECT_EQ(r.radiance[i], glm::vec3(0));
        EXPECT_EQ(r.emission[i], view.beyond({x, y}));
        lit += r.emission[i] == glm::vec3(4, 5, 6);
      }
    EXPECT_GT(surface, 5);
    EXPECT_EQ(lit > 10, visible);
    if (!visible) {
      EXPECT_EQ(lit, 0);
    }
    EXPECT_EQ(r.surface_pixels, unsigned(surface));
  }
}

TEST(Backdrop, IsSeenWhereNoSurfaceIs) { expect_beyond(methods::lightcuts); }
TEST(Backdrop, IsSeenBesideSquaresOfPixels) { expect_beyond(methods::block_cuts); }

} // namespace
} // namespace lightcuts
