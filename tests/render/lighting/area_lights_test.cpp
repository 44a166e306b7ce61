// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/area_lights.h>

#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/occluder.h>

#include <tests/render/support/box_scene.h>
#include <tests/render/support/refusal.h>

namespace lightcuts {
namespace {

using test::add_quad;
using test::add_surface;

using std::numbers::pi;

/// A floor that does not emit, and three lamps of different size, colour and attitude.
Scene lamps() {
  Scene scene;
  add_quad(scene, add_surface(scene, glm::vec3(0.5F)), {-4, 0, 4}, {4, 0, 4}, {4, 0, -4},
           {-4, 0, -4});
  add_quad(scene, add_surface(scene, glm::vec3(0), {3, 2, 1}), {-1, 2, -1}, {1, 2, -1}, {1, 2, 1},
           {-1, 2, 1}); // downwards, 4 m^2
  add_quad(scene, add_surface(scene, glm::vec3(0), {0, 0, 50}), {2, 1, 0}, {2.1F, 1, 0},
           {2.1F, 1.1F, 0.03F}, {2, 1.1F, 0.03F});
  add_quad(scene, add_surface(scene, glm::vec3(0), glm::vec3(0.001F)), {-2, 1, 0}, {-2, 1, 0.01F},
           {-2, 1.01F, 0.01F}, {-2, 1.01F, 0});
  return scene;
}

struct Corners {
  glm::dvec3 a, b, c;
  [[nodiscard]] glm::dvec3 cross() const { return glm::cross(b - a, c - a); }
};

Corners corners(const Scene& scene, std::size_t t) {
  const glm::uvec3 v = scene.mesh.triangles[t];
  return {scene.mesh.positions[v.x], scene.mesh.positions[v.y], scene.mesh.positions[v.z]};
}

/// The emissive triangle whose plane and edges hold p within `gap` metres, or -1.
int triangle_at(const Scene& scene, const glm::dvec3& p, double gap) {
  for (std::size_t t = 2; t < scene.mesh.triangles.size(); ++t) {
    const Corners at = corners(scene, t);
    const glm::dvec3 n = glm::normalize(at.cross());
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return glm::dot(glm::cross(to - from, p - from), n) >= -gap * glm::length(to - from);
    };
    if (std::abs(glm::dot(n, p - at.a)) <= gap && inside(at.a, at.b) && inside(at.b, at.c) &&
        inside(at.c, at.a))
      return static_cast<int>(t);
  }
  return -1;
}

LightSet lights_of(const AreaLights& config) {
  Scene scene = lamps();
  add_area_lights(scene, config);
  return scene.lights;
}

TEST(AreaLights, lie_on_the_emissive_triangles_and_face_their_fronts) {
  Scene scene = lamps();
  add_area_lights(scene, {.count = 500});
  EXPECT_EQ(scene.lights.size(), 500U);
  for (const Light& light : scene.lights) {
    EXPECT_EQ(light.kind, LightKind::oriented);
    const int t = triangle_at(scene, light.position, 1e-6);
    ASSERT_GE(t, 2);
    const Corners at = corners(scene, static_cast<std::size_t>(t));
    EXPECT_LT(glm::distance(glm::dvec3(light.axis), glm::normalize(at.cross())), 1e-6);
    // Never behind, where its own triangle would shadow it; 1e-15 are this line's own roundings.
    EXPECT_GE(glm::dot(at.cross(), glm::dvec3(light.position) - at.a), -1e-15);
  }
}

// By lamp, as a light on an edge lies on two triangles: told apart by their axes.
TEST(AreaLights, have_each_triangles_power_exactly_but_for_rounding) {
  for (const std::uint32_t count : {1U, 6U, 7U, 1000U}) {
    Scene scene = lamps();
    add_area_lights(scene, {.count = count});
    std::map<std::size_t, glm::dvec3> power; // by surface
    for (const Light& light : scene.lights) {
      const std::size_t surface = light.axis.y < -0.9F ? 1 : light.axis.x == 0 ? 2 : 3;
      power[surface] += pi * glm::dvec3(light.intensity);
    }
    for (std::size_t t = 2; t < scene.mesh.triangles.size(); t += 2) {
      const std::size_t surface = scene.mesh.surface[t];
      const double area = glm::length(corners(scene, t).cross()); // of both triangles
      const glm::dvec3 expected = pi * area * glm::dvec3(scene.surfaces[surface].emission);
      // Each intensity is rounded once, by at most 2^-24 of itself.
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(power[surface][c], expected[c], 0x1p-23 * expected[c]) << count;
    }
  }
}

TEST(AreaLights, are_shared_out_by_power_and_leave_no_triangle_dark) {
  Scene scene = lamps();
  add_area_lights(scene, {.count = 1000});
  std::map<int, int> count;
  for (const Light& light : scene.lights) ++count[triangle_at(scene, light.position, 1e-6)];
  // Means over the channels: 2 * 4 m^2, 16.67 * 0.01044 m^2, 0.001 * 0.0001 m^2.
  EXPECT_NEAR(count[2], 0.5 * 1000 * 8 / 8.174, 2);
  EXPECT_NEAR(count[4], 0.5 * 1000 * 0.174 / 8.174, 2);
  EXPECT_EQ(count[6], 1);
  EXPECT_EQ(count[7], 1);
  EXPECT_EQ(lights_of({.count = 2}).size(), 6U); // one for each
}

TEST(AreaLights, are_shared_out_alike_to_large_triangles_after_many_small_ones) {
  Scene scene;
  const std::uint32_t lamp = add_surface(scene, glm::vec3(0), glm::vec3(1));
  for (int i = 0; i < 50; ++i) // 100 triangles
    add_quad(scene, lamp, {0, 0, 0}, {0.01F, 0, 0}, {0.01F, 0.01F, 0}, {0, 0.01F, 0});
  add_quad(scene, lamp, {10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0});
  add_area_lights(scene, {.count = 200});
  int lower = 0, upper = 0; // right and left of the diagonal
  for (const Light& light : scene.lights) {
    if (light.position.x < 1) continue;
    ++(light.position.x - 10 > light.position.y ? lower : upper);
  }
  EXPECT_EQ(lower, 50);
  EXPECT_EQ(upper, 50);
}

TEST(AreaLights, spread_evenly_over_a_triangle) {
  Scene scene;
  const std::uint32_t lamp = add_surface(scene, glm::vec3(0), glm::vec3(1));
  add_quad(scene, lamp, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  scene.mesh.triangles.pop_back();
  scene.mesh.surface.pop_back();
  add_area_lights(scene, {.count = 4096});
  glm::dvec3 centroid(0);
  int cells[8][8] = {};
  for (const Light& light : scene.lights) {
    centroid += glm::dvec3(light.position) / 4096.0;
    ++cells[static_cast<int>(8 * light.position.x)][static_cast<int>(8 * light.position.y)];
  }
  // Random points would be off by 0.004.
  EXPECT_LT(glm::distance(centroid, glm::dvec3(2.0 / 3, 1.0 / 3, 0)), 5e-4);
  // 2/64 of the triangle: 128; random points would spread with a standard deviation of 11.
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < x; ++y) EXPECT_NEAR(cells[x][y], 128, 24) << x << ' ' << y;
}

TEST(AreaLights, are_seen_by_what_lies_in_front_and_not_shadowed_by_their_own_surface) {
  Scene scene = lamps();
  add_area_lights(scene, {.count = 600});
  const Occluder occluder(scene.mesh);
  int cast = 0;
  for (const Light& light : scene.lights)
    for (int k = 0; k < 20; ++k) {
      // Down to 1/40 of a right angle off the surface.
      const glm::vec3 side =
          std::abs(light.axis.x) < 0.5F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
      const glm::vec3 across = glm::normalize(glm::cross(light.axis, side));
      const float slope = static_cast<float>(k + 1) / 20;
      const glm::vec3 receiver = light.position + 0.5F * (slope * light.axis + across);
      EXPECT_FALSE(occluder.occluded(shadow_ray(receiver, light.position)));
      ++cast;
    }
  EXPECT_EQ(cast, 12000);
}

TEST(AreaLights, look_from_afar_like_one_light_of_their_power) {
  Scene scene = lamps();
  add_area_lights(scene, {.count = 64});
  const glm::dvec3 far(0, -300, 0);
  double irradiance = 0; // red; of the large lamp only, on a surface that faces up
  for (const Light& light : scene.lights) {
    const glm::dvec3 q = far - glm::dvec3(light.position);
    const double cosine = glm::dot(glm::normalize(q), glm::dvec3(light.axis));
    irradiance += light.intensity.r * std::max(0.0, cosine) / glm::dot(q, q);
  }
  EXPECT_NEAR(irradiance, 3 * 4 / (302.0 * 302.0), 1e-4 * 3 * 4 / (302.0 * 302.0));
}

TEST(AreaLights, have_the_same_bits_for_the_same_seed) {
  EXPECT_TRUE(test::same_bits(lights_of({.count = 100}), lights_of({.count = 100})));
  EXPECT_FALSE(test::same_bits(lights_of({.count = 100}), lights_of({.count = 100, .seed = 2})));
}

TEST(AreaLights, are_added_and_noted) {
  Scene scene = lamps();
  scene.lights.add_omni({0, 1, 0}, glm::vec3(1));
  add_area_lights(scene, {.count = 312});
  EXPECT_EQ(scene.lights.size(), 313U);
  EXPECT_THAT(scene.notes, testing::ElementsAre("312 area lights from 6 triangles, 25.68 W"));
}

TEST(AreaLights, take_extreme_sizes) {
  for (const float size : {1e-18F, 1e18F}) {
    Scene scene;
    const std::uint32_t lamp = add_surface(scene, glm::vec3(0), glm::vec3(1));
    add_quad(scene, lamp, glm::vec3(0), {size, 0, 0}, {size, size, 0}, {0, size, 0});
    add_area_lights(scene, {.count = 10});
    EXPECT_NEAR(test::oriented_power(scene.lights).x / (double(size) * size), pi, 1e-5);
  }
}

TEST(AreaLights, refuse_what_they_cannot_do_and_leave_the_scene_alone) {
  const auto refuses = [](const std::string& part, Scene scene, std::uint32_t count) {
    const std::size_t before = scene.lights.size();
    expect_refusal(part, [&] { add_area_lights(scene, {.count = count}); });
    EXPECT_EQ(scene.lights.size(), before);
    EXPECT_TRUE(scene.notes.empty());
  };
  refuses("area lights: count is 0, expected 1 to 100000000", lamps(), 0);
  refuses("area lights: count is 100000001", lamps(), 100000001);
  refuses("area lights: no surface emits light", test::closed_box(glm::vec3(1), glm::vec3(1)), 5);
  Scene flat = lamps(); // emissive, but without area
  for (glm::vec3& p : flat.mesh.positions) p = {1, p.y, 1};
  refuses("no surface emits light", flat, 5);
  Scene bright = lamps();
  bright.surfaces[1].emission.g = 3e38F;
  refuses("area lights: light", bright, 1);
}

} // namespace
} // namespace lightcuts
