// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/virtual_point_lights.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/render/support/box_scene.h>
#include <tests/render/support/first_bounce.h>
#include <tests/render/support/refusal.h>

namespace lightcuts {
namespace {

using test::lamp_position;
using test::lit_room;
using test::oriented_power;
using test::room_size;

using std::numbers::pi;
Scene traced(Scene scene, const VirtualPointLights& config) {
  add_virtual_point_lights(scene, config);
  return scene;
}

/// Power reflected in a closed white room by the only light of `lights`, once.
glm::dvec3 power_in_room(const LightSet& lights, std::uint32_t paths = 20000) {
  Scene scene = test::closed_box(room_size, glm::vec3(1));
  scene.lights = lights;
  return oriented_power(traced(scene, {.paths = paths, .bounces = 1}).lights, 1);
}

TEST(VirtualPointLights, have_the_power_that_a_closed_room_reflects_at_first) {
  const Scene scene = traced(lit_room({0.8F, 0.5F, 0}, {3, 2, 1}), {.paths = 5000, .bounces = 1});
  EXPECT_EQ(scene.lights.size(), 1 + 5000U); // no path gets out
  const glm::dvec3 power = oriented_power(scene.lights, 1);
  // Each intensity is rounded once, and is one of at most 5000 roundings.
  EXPECT_NEAR(power.r / (4 * pi * 3 * double(0.8F)), 1, 0x1p-23);
  EXPECT_NEAR(power.g / (4 * pi * 2 * 0.5), 1, 0x1p-23);
  EXPECT_EQ(power.b, 0);
}

TEST(VirtualPointLights, lose_a_factor_of_the_reflectance_with_every_further_bounce) {
  const glm::dvec3 reflectance(0.8F, 0.5F, 0.25F);
  glm::dvec3 before = oriented_power(
      traced(lit_room(glm::vec3(reflectance)), {.paths = 20000, .bounces = 1}).lights, 1);
  glm::dvec3 expected = 4 * pi * reflectance;
  for (std::uint32_t bounces = 2; bounces <= 5; ++bounces) {
    const glm::dvec3 power = oriented_power(
        traced(lit_room(glm::vec3(reflectance)), {.paths = 20000, .bounces = bounces}).lights, 1);
    expected *= reflectance;
    // 20000 * 0.8^4 paths or more get there: a standard deviation of 0.9 % or less.
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR((power - before)[c] / expected[c], 1, 0.03) << bounces << ' ' << c;
    before = power;
  }
}

TEST(VirtualPointLights, have_all_reflected_power_where_paths_may_be_long) {
  const Scene scene = traced(lit_room(glm::vec3(0.7F)), {.paths = 20000, .bounces = 1000});
  EXPECT_NEAR(oriented_power(scene.lights, 1).r / (4 * pi * 0.7 / 0.3), 1, 0.02);
  // Roulette keeps their powers alike: as many as 0.7^(k-1) paths.
  EXPECT_NEAR(double(scene.lights.size()) / (20000 / 0.3), 1, 0.02);
}

TEST(VirtualPointLights, start_with_the_power_of_an_oriented_light) {
  LightSet lights;
  lights.add_oriented({1, 3, 2}, {0, -1, 0}, {1, 2, 3}); // on the ceiling
  EXPECT_NEAR(power_in_room(lights).g, pi * 2, 1e-5);
}

TEST(VirtualPointLights, start_in_front_of_the_surface_that_an_oriented_light_lies_on) {
  Scene scene = test::closed_box(room_size, glm::vec3(1));
  scene.lights.add_oriented({1, 3, 2}, {0, -1, 0}, glm::vec3(1));
  scene = traced(scene, {.paths = 1000, .bounces = 1});
  for (std::size_t i = 1; i < scene.lights.size(); ++i) EXPECT_LT(scene.lights[i].position.y, 3);
}

TEST(VirtualPointLights, start_with_the_power_of_a_spot) {
  for (const auto& [inner, outer] : {std::pair{0.0F, 0.4F}, {0.3F, 1.0F}, {1.5F, 3.1F}}) {
    LightSet lights;
    lights.add_spot(lamp_position, {0, 0.6F, 0.8F}, glm::vec3(1), inner, outer);
    double expected = 0; // the midpoint rule over the angle
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double angle = (i + 0.5) * pi / steps;
      const double t =
          (std::cos(angle) - std::cos(outer)) / (double(std::cos(inner)) - std::cos(outer));
      expected += 2 * pi * std::sin(angle) * std::pow(std::clamp(t, 0.0, 1.0), 2) * pi / steps;
    }
    EXPECT_NEAR(power_in_room(lights).r / expected, 1, 1e-5);
  }
}

TEST(VirtualPointLights, start_with_what_a_directional_light_sends_through_the_scenes_outline) {
  LightSet lights;
  lights.add_directional({0, -1, 0}, glm::vec3(5));
  EXPECT_NEAR(power_in_room(lights).r / (5.0 * 2 * 4), 1, 0.01); // the roof
  const glm::vec3 travel(0.6F, 0, 0.8F);
  LightSet slanted;
  slanted.add_directional(travel, glm::vec3(5));
  EXPECT_NEAR(power_in_room(slanted).r / (5 * (0.6 * 3 * 4 + 0.8 * 2 * 3)), 1, 0.01);
}

/// Irradiance of a surface with normal n at x by a light of intensity 1 within nothing.
double direct(const Light& light, const glm::vec3& x, const glm::vec3& n) {
  LightSet lights;
  lights.add(light);
  return test::irradiance(lights, 0, x, n);
}

// The first lights' power on a patch of the floor is the irradiance there.
TEST(VirtualPointLights, lie_where_the_light_falls) {
  LightSet kinds;
  kinds.add_omni(lamp_position, glm::vec3(1));
  kinds.add_oriented(lamp_position, {0, -0.8F, 0.6F}, glm::vec3(1));
  kinds.add_spot(lamp_position, {0, -0.8F, 0.6F}, glm::vec3(1), 0.2F, 1.2F);
  for (const Light& light : kinds) {
    Scene scene = test::closed_box(room_size, glm::vec3(1));
    scene.lights.add(light);
    scene = traced(scene, {.paths = 50000, .bounces = 1});
    double power[2][4] = {};
    for (std::size_t i = 1; i < scene.lights.size(); ++i) {
      const glm::vec3& p = scene.lights[i].position;
      if (p.y == 0) power[int(p.x)][int(p.z)] += pi * scene.lights[i].intensity.r;
    }
    for (int x = 0; x < 2; ++x)
      for (int z = 0; z < 4; ++z) {
        double expected = 0; // the mean over the square metre
        for (int k = 0; k < 400; ++k)
          expected += direct(light,
                             {float(x) + (float(k % 20) + 0.5F) / 20, 0,
                              float(z) + (float(k / 20) + 0.5F) / 20}, // NOLINT
                             {0, 1, 0}) /
                      400;
        EXPECT_NEAR(power[x][z], expected, 0.05 * expected + 0.002) << x << ' ' << z;
      }
  }
}

TEST(VirtualPointLights, converge_to_the_light_that_the_walls_reflect) {
  const auto error = [](std::uint32_t paths) {
    return test::first_bounce_error(traced(lit_room(glm::vec3(1)), {.paths = paths, .bounces = 1}),
                                    room_size, lamp_position);
  };
  const double coarse = error(100), fine = error(10000);
  EXPECT_LT(fine, 0.01);
  EXPECT_LT(4 * fine, coarse); // 10 is expected of random paths
}

TEST(VirtualPointLights, are_on_the_side_that_was_lit) {
  LightSet kinds;
  kinds.add_omni({0, -1, 0}, glm::vec3(1));
  kinds.add_directional({0, 1, 0}, glm::vec3(1));
  for (const Light& light : kinds) {
    Scene scene;
    const std::uint32_t paper = test::add_surface(scene, glm::vec3(0.5F));
    test::add_quad(scene, paper, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}); // faces up
    scene.lights.add(light);
    scene = traced(scene, {.paths = 1000, .bounces = 1});
    EXPECT_GT(scene.lights.size(), 100U);
    for (std::size_t i = 1; i < scene.lights.size(); ++i)
      EXPECT_EQ(scene.lights[i].axis, glm::vec3(0, -1, 0));
  }
}

TEST(VirtualPointLights, stay_inside_a_closed_room_at_any_angle) {
  Scene scene = lit_room(glm::vec3(0.9F));
  const glm::vec3 u(0.48F, 0.64F, 0.6F), v(0.8F, -0.6F, 0), w = glm::cross(u, v);
  for (glm::vec3& p : scene.mesh.positions) p = u * p.x + v * p.y + w * p.z;
  const auto turned = [&](const glm::vec3& p) { return u * p.x + v * p.y + w * p.z; };
  scene.lights = LightSet();
  scene.lights.add_omni(turned(lamp_position), glm::vec3(1));
  scene = traced(scene, {.paths = 5000, .bounces = 1000});
  EXPECT_NEAR(double(scene.lights.size()) / (5000 / 0.1), 1, 0.05);
  const glm::vec3 centre = turned(0.5F * room_size);
  for (std::size_t i = 1; i < scene.lights.size(); ++i)
    ASSERT_GT(glm::dot(scene.lights[i].axis, centre - scene.lights[i].position), 0.9F);
}

TEST(VirtualPointLights, are_not_where_something_is_in_between) {
  Scene scene = lit_room(glm::vec3(0.5F));
  test::add_quad(scene, 0, {0, 1, 0}, {2, 1, 0}, {2, 1, 4}, {0, 1, 4}); // a false floor
  scene = traced(scene, {.paths = 2000, .bounces = 1});
  for (std::size_t i = 1; i < scene.lights.size(); ++i) EXPECT_GE(scene.lights[i].position.y, 1);
}

TEST(VirtualPointLights, start_from_all_lights_in_proportion_to_their_power) {
  Scene scene = lit_room(glm::vec3(1), {3, 0, 0});
  scene.lights.add_omni({1, 1, 1}, glm::vec3(0)); // black
  scene.lights.add_omni({1, 1, 1}, {0, 0, 1});
  scene = traced(scene, {.paths = 4000, .bounces = 1});
  int red_lights = 0, blue_lights = 0;
  for (std::size_t i = 3; i < scene.lights.size(); ++i)
    ++(scene.lights[i].intensity.r > 0 ? red_lights : blue_lights);
  EXPECT_EQ(red_lights, 3000);
  EXPECT_EQ(blue_lights, 1000);
}

TEST(VirtualPointLights, take_the_reflectance_from_the_texture) {
  Scene scene = test::textured_square();
  scene.lights.add_directional({0, -1, 0}, glm::vec3(1));
  scene = traced(scene, {.paths = 20000, .bounces = 1});
  EXPECT_NEAR(oriented_power(scene.lights, 1).r, 0.5, 0.01);
  for (std::size_t i = 1; i < scene.lights.size(); ++i)
    EXPECT_GT(scene.lights[i].position.x, -0.25F); // black as far as there
}

TEST(VirtualPointLights, have_the_same_bits_for_the_same_seed) {
  const auto lights = [](std::uint64_t seed) {
    return traced(lit_room(glm::vec3(0.5F)), {.paths = 200, .seed = seed}).lights;
  };
  EXPECT_TRUE(test::same_bits(lights(1), lights(1)));
  EXPECT_FALSE(test::same_bits(lights(1), lights(2)));
}

TEST(VirtualPointLights, are_noted_with_a_distance_to_clamp_to_that_is_not_set) {
  const Scene scene = traced(lit_room(glm::vec3(0.5F)), {.paths = 100, .bounces = 1});
  EXPECT_THAT(scene.notes, testing::ElementsAre("100 VPLs from 100 light paths, 6.283 W; for a "
                                                "min_distance consider 0.407"));
  EXPECT_EQ(scene.lights.min_distance(), 0);
  const Scene black = traced(lit_room(glm::vec3(0)), {.paths = 100});
  EXPECT_THAT(black.notes, testing::ElementsAre("0 VPLs from 100 light paths, 0 W"));
}

TEST(VirtualPointLights, refuse_what_they_cannot_do_and_leave_the_scene_alone) {
  const auto refuses = [](const std::string& part, Scene scene, const VirtualPointLights& config) {
    const std::size_t before = scene.lights.size();
    expect_refusal(part, [&] { add_virtual_point_lights(scene, config); });
    EXPECT_EQ(scene.lights.size(), before);
    EXPECT_TRUE(scene.notes.empty());
  };
  const Scene room = lit_room(glm::vec3(0.5F));
  refuses("VPLs: paths is 0, expected 1 to 100000000", room, {.paths = 0});
  refuses("VPLs: bounces is 0, expected 1 to 1000", room, {.bounces = 0});
  refuses("VPLs: bounces is 1001", room, {.bounces = 1001});
  refuses("VPLs: no light to start from", test::closed_box(room_size, glm::vec3(1)), {});
  refuses("VPLs: no light to start from", lit_room(glm::vec3(1), glm::vec3(0)), {});
  refuses("VPLs: light 0: intensity.r is inf", lit_room(glm::vec3(1), glm::vec3(3e38F)),
          {.paths = 1});
}

} // namespace
} // namespace lightcuts
