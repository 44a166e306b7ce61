// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/surfels.h>

#include <algorithm>
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
Scene with_surfels(Scene scene, const Surfels& config) {
  add_surfels(scene, config);
  return scene;
}

/// A plate of 2 m x 3 m that faces up, 60 % grey, and one directional light on it.
Scene lit_plate(const glm::vec3& travel) {
  Scene scene;
  test::add_quad(scene, test::add_surface(scene, glm::vec3(0.6F)), {0, 1, 0}, {0, 1, 3}, {2, 1, 3},
                 {2, 1, 0});
  scene.lights.add_directional(travel, {1, 2, 4});
  return scene;
}

TEST(Surfels, share_out_the_area_exactly) {
  for (const std::uint32_t count : {1U, 7U, 1000U}) {
    const Scene scene = with_surfels(lit_plate({0, -1, 0}), {.count = count});
    EXPECT_EQ(scene.lights.size(), 1 + count);
    const glm::dvec3 power = oriented_power(scene.lights, 1);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(power[c] / (double(0.6F) * (1 << c) * 2 * 3), 1, 1e-6) << count;
  }
}

TEST(Surfels, face_the_side_that_is_lit) {
  for (const float side : {1.0F, -1.0F}) {
    const Scene scene = with_surfels(lit_plate({0, -side * 0.6F, 0.8F}), {.count = 50});
    EXPECT_EQ(scene.lights.size(), 51U);
    for (std::size_t i = 1; i < scene.lights.size(); ++i) {
      EXPECT_EQ(scene.lights[i].kind, LightKind::oriented);
      EXPECT_EQ(scene.lights[i].axis, glm::vec3(0, side, 0));
      EXPECT_EQ(scene.lights[i].position.y, 1);
    }
    EXPECT_NEAR(oriented_power(scene.lights, 1).r, 0.6 * 0.6 * 6, 1e-5);
  }
}

TEST(Surfels, reflect_both_sides_where_both_are_lit) {
  Scene scene = lit_plate({0, -1, 0});
  scene.lights.add_directional({0, 1, 0}, glm::vec3(10));
  scene = with_surfels(scene, {.count = 50});
  EXPECT_EQ(scene.lights.size(), 2 + 100U);
  EXPECT_NEAR(oriented_power(scene.lights, 2).r, 0.6 * 11 * 6, 1e-4);
}

TEST(Surfels, lie_evenly_over_the_area) {
  const Scene scene = with_surfels(lit_room(glm::vec3(1)), {.count = 5200});
  int floor = 0, quarter = 0, side = 0;
  for (std::size_t i = 1; i < scene.lights.size(); ++i) {
    const glm::vec3& p = scene.lights[i].position;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(p[axis], 0);
      EXPECT_LE(p[axis], room_size[axis]);
    }
    if (p.x == 0) ++side;
    if (p.y > 0) continue;
    ++floor;
    if (p.x < 1 && p.z < 2) ++quarter;
  }
  EXPECT_NEAR(floor, 800, 2);
  EXPECT_NEAR(side, 1200, 2);
  EXPECT_NEAR(quarter, 200, 10); // random points would spread with a standard deviation of 12
}

TEST(Surfels, converge_to_the_power_that_a_closed_room_reflects) {
  const auto error = [](std::uint32_t count) {
    const Scene scene = with_surfels(lit_room({0.8F, 0.5F, 0}, {3, 2, 1}), {.count = count});
    const glm::dvec3 power = oriented_power(scene.lights, 1);
    EXPECT_EQ(power.b, 0);
    EXPECT_NEAR(power.g / power.r, 2 * 0.5 / (3 * 0.8), 1e-6);
    return std::abs(power.r / (4 * pi * 3 * 0.8) - 1);
  };
  EXPECT_LT(error(500), 0.02);
  EXPECT_LT(error(50000), 2e-4);
}

TEST(Surfels, converge_to_the_light_that_the_walls_reflect) {
  const auto error = [](std::uint32_t count) {
    return test::first_bounce_error(with_surfels(lit_room(glm::vec3(1)), {.count = count}),
                                    room_size, lamp_position);
  };
  const double coarse = error(100), fine = error(10000);
  EXPECT_LT(fine, 0.005);
  EXPECT_LT(8 * fine, coarse); // 10 is expected of random points
}

TEST(Surfels, are_dark_in_the_shadow) {
  Scene scene = lit_room(glm::vec3(0.5F));
  test::add_quad(scene, 0, {0, 1, 0}, {2, 1, 0}, {2, 1, 4}, {0, 1, 4}); // a false floor
  scene = with_surfels(scene, {.count = 1000});
  EXPECT_GT(scene.lights.size(), 600U);
  EXPECT_LT(scene.lights.size(), 800U);
  for (std::size_t i = 1; i < scene.lights.size(); ++i) EXPECT_GE(scene.lights[i].position.y, 1);
}

TEST(Surfels, reflect_every_kind_of_light) {
  LightSet kinds;
  kinds.add_oriented({1, 3, 2}, {0, -1, 0}, glm::vec3(1));
  kinds.add_spot({1, 2, 2}, {0, -1, 0}, glm::vec3(1), 0.2F, 0.7F);
  const double c = std::cos(0.2), o = std::cos(0.7);
  const double powers[] = {pi, 2 * pi * ((1 - c) + (c - o) / 3)};
  for (int i = 0; i < 2; ++i) {
    Scene scene = test::closed_box(room_size, glm::vec3(1));
    scene.lights.add(kinds[i]);
    EXPECT_NEAR(oriented_power(with_surfels(scene, {.count = 20000}).lights, 1).r / powers[i], 1,
                0.01);
  }
}

TEST(Surfels, take_the_reflectance_from_the_texture) {
  Scene scene = test::textured_square();
  scene.lights.add_directional({0, -1, 0}, glm::vec3(1));
  scene = with_surfels(scene, {.count = 2000});
  EXPECT_NEAR(oriented_power(scene.lights, 1).r, 0.5, 0.01);
  for (std::size_t i = 1; i < scene.lights.size(); ++i)
    EXPECT_GT(scene.lights[i].position.x, -0.25F); // black as far as there
}

TEST(Surfels, clamp_the_distance_to_the_lights_like_the_scene) {
  Scene scene = lit_room(glm::vec3(1));
  scene.lights.set_min_distance(10); // beyond the room
  scene = with_surfels(scene, {.count = 100});
  float largest = 0;
  for (std::size_t i = 1; i < scene.lights.size(); ++i)
    largest = std::max(largest, scene.lights[i].intensity.r);
  EXPECT_LE(largest, 1 / (pi * 100) * 52 / 100 * (1 + 0x1p-23)); // as at 10 m, straight on
  EXPECT_GT(largest, 0.9 / (pi * 100) * 52 / 100);
}

TEST(Surfels, have_the_same_bits_for_the_same_seed_and_any_number_of_threads) {
  const auto lights = [](std::uint64_t seed, unsigned threads) {
    return with_surfels(lit_room(glm::vec3(0.5F)), {.count = 200, .seed = seed, .threads = threads})
        .lights;
  };
  EXPECT_TRUE(test::same_bits(lights(1, 1), lights(1, 3)));
  EXPECT_FALSE(test::same_bits(lights(1, 1), lights(2, 1)));
}

TEST(Surfels, are_noted_with_a_distance_to_clamp_to_that_is_not_set) {
  const Scene scene = with_surfels(lit_plate({0, -1, 0}), {.count = 100});
  EXPECT_THAT(scene.notes, testing::ElementsAre("100 lights from 100 surfels of 0.06 m^2, 8.4 W; "
                                                "for a min_distance consider 0.138"));
  EXPECT_EQ(scene.lights.min_distance(), 0);
}

TEST(Surfels, refuse_what_they_cannot_do_and_leave_the_scene_alone) {
  const auto refuses = [](const std::string& part, Scene scene, std::uint32_t count) {
    const std::size_t before = scene.lights.size();
    expect_refusal(part, [&] { add_surfels(scene, {.count = count}); });
    EXPECT_EQ(scene.lights.size(), before);
    EXPECT_TRUE(scene.notes.empty());
  };
  refuses("surfels: count is 0, expected 1 to 10000000", lit_room(glm::vec3(1)), 0);
  refuses("surfels: no light to reflect", test::closed_box(glm::vec3(1), glm::vec3(1)), 5);
  Scene flat = lit_room(glm::vec3(1));
  for (glm::vec3& p : flat.mesh.positions) p = {1, p.y, 1};
  refuses("surfels: no triangle has an area", flat, 5);
  Scene bright = lit_plate({0, -1, 0});
  bright.lights.add_directional({0, -1, 0}, glm::vec3(3e38F));
  for (glm::vec3& p : bright.mesh.positions) p *= 1000;
  refuses("surfels: light 0: intensity.r is inf", bright, 5);
}

} // namespace
} // namespace lightcuts
