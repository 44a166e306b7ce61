// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/environment/environment_lights.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/numerics/splitmix.h>

#include <tests/render/support/box_scene.h>
#include <tests/render/support/refusal.h>

namespace lightcuts {
namespace {

using std::numbers::pi;

EnvironmentMap grey_map(glm::uvec2 size, float radiance) {
  return {
      "sky", size, std::vector<glm::vec3>(std::size_t{size.x} * size.y, glm::vec3(radiance)), {}};
}

/// Noise, brighter above, with a sun of one pixel and a black patch.
EnvironmentMap sunny_map() {
  EnvironmentMap map = grey_map({64, 32}, 0);
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    const auto noise = static_cast<float>(splitmix64(i) >> 40) * 0x1p-24F;
    map.radiance[i] = glm::vec3(noise, 0.5F, 1 - noise) * (i < 1024 ? 2.0F : 0.5F);
    if (i > 1500 && i < 1600) map.radiance[i] = glm::vec3(0);
  }
  map.radiance[64 * 7 + 20] = {9000, 8000, 7000};
  return map;
}

LightSet lights_of(const EnvironmentMap& map, std::uint32_t count) {
  Scene scene;
  add_environment_lights(scene, map, {.count = count});
  return scene.lights;
}

/// The documented direction of a pixel, by the C library.
glm::dvec3 direction(const EnvironmentMap& map, std::size_t pixel) {
  const double polar = pi * (double(pixel / map.size.x) + 0.5) / map.size.y;
  const double longitude = pi - 2 * pi * (double(pixel % map.size.x) + 0.5) / map.size.x;
  return {std::sin(polar) * std::sin(longitude), std::cos(polar),
          std::sin(polar) * std::cos(longitude)};
}

/// Sum over the pixels of radiance * solid angle * weight(direction).
template <class Weight>
glm::dvec3 sum_over(const EnvironmentMap& map, const Weight& weight) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    const double upper = pi * double(i / map.size.x) / map.size.y, lower = upper + pi / map.size.y;
    const double solid_angle = 2 * pi / map.size.x * (std::cos(upper) - std::cos(lower));
    sum += glm::dvec3(map.radiance[i]) * (solid_angle * weight(direction(map, i)));
  }
  return sum;
}

glm::dvec3 total(const LightSet& lights) {
  glm::dvec3 sum(0);
  for (const Light& light : lights) sum += glm::dvec3(light.intensity);
  return sum;
}

TEST(EnvironmentLights, conserve_the_total_of_every_channel) {
  const EnvironmentMap map = sunny_map();
  const glm::dvec3 expected = sum_over(map, [](const auto&) { return 1.0; });
  for (const std::uint32_t count : {1U, 2U, 100U, 1024U, 5000U}) {
    const glm::dvec3 sum = total(lights_of(map, count));
    // Each light is rounded once, by at most 2^-24 of itself.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / expected[c], 1, 0x1p-23) << count;
  }
  EXPECT_NEAR(total(lights_of(grey_map({7, 5}, 3), 4)).x, 3 * 4 * pi, 1e-5);
}

TEST(EnvironmentLights, are_as_many_as_asked_for_or_as_pixels_are_lit) {
  for (const std::uint32_t count : {1U, 2U, 3U, 1000U})
    EXPECT_EQ(lights_of(sunny_map(), count).size(), count);
  EXPECT_EQ(lights_of(sunny_map(), 5000).size(), 64U * 32 - 99);
  EXPECT_EQ(lights_of(grey_map({4, 2}, 0), 10).size(), 0U);
  EnvironmentMap star = grey_map({64, 32}, 0);
  star.radiance[777] = glm::vec3(1);
  const LightSet lights = lights_of(star, 10);
  ASSERT_EQ(lights.size(), 1U);
  EXPECT_LT(glm::distance(glm::dvec3(lights[0].position), direction(star, 777)), 1e-7);
}

TEST(EnvironmentLights, come_from_where_the_image_looks) {
  const auto expect_at = [](glm::uvec2 size, std::size_t pixel, const glm::vec3& towards) {
    EnvironmentMap map = grey_map(size, 0);
    map.radiance[pixel] = glm::vec3(1);
    const LightSet lights = lights_of(map, 1);
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(lights[0].kind, LightKind::directional);
    EXPECT_LT(glm::distance(lights[0].position, towards), 0.01F);
  };
  expect_at({2, 1}, 0, {1, 0, 0});      // a quarter from the left
  expect_at({2, 1}, 1, {-1, 0, 0});     // a quarter from the right
  expect_at({3, 1}, 1, {0, 0, 1});      // the middle
  expect_at({999, 1}, 0, {0, 0, -1});   // the left edge
  expect_at({999, 1}, 998, {0, 0, -1}); // the right edge
  expect_at({1, 999}, 0, {0, 1, 0});    // the top
  expect_at({1, 999}, 998, {0, -1, 0});
}

TEST(EnvironmentLights, light_surfaces_like_the_map) {
  const EnvironmentMap map = sunny_map();
  const LightSet lights = lights_of(map, 1024);
  for (int k = 0; k < 30; ++k) {
    const glm::dvec3 n = direction(map, splitmix64(k) % map.radiance.size());
    const glm::dvec3 expected =
        sum_over(map, [&](const glm::dvec3& d) { return std::max(0.0, glm::dot(n, d)); });
    glm::dvec3 sum(0);
    for (const Light& light : lights)
      sum += glm::dvec3(light.intensity) * std::max(0.0, glm::dot(n, glm::dvec3(light.position)));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / expected[c], 1, 0.003);
  }
}

TEST(EnvironmentLights, give_the_sun_a_light_of_its_own_and_spread_over_the_rest) {
  const EnvironmentMap map = sunny_map();
  const std::size_t sun = 64 * 7 + 20;
  const glm::dvec3 in_sun = sum_over(map, [&](const glm::dvec3& d) {
    return glm::distance(d, direction(map, sun)) < 1e-9 ? 1.0 : 0.0;
  });
  const LightSet lights = lights_of(map, 64);
  int at_sun = 0;
  for (const Light& light : lights) {
    if (light.intensity.r < 0.5 * in_sun.r) {
      EXPECT_LT(light.intensity.r, 2);
      continue;
    }
    ++at_sun;
    EXPECT_NEAR(light.intensity.r, in_sun.r, 1e-6 * in_sun.r);
    EXPECT_LT(glm::distance(glm::dvec3(light.position), direction(map, sun)), 1e-6);
  }
  EXPECT_EQ(at_sun, 1);
}

TEST(EnvironmentLights, have_a_direction_even_where_all_directions_are_alike) {
  const EnvironmentMap map = grey_map({64, 32}, 1);
  const LightSet lights = lights_of(map, 1);
  ASSERT_EQ(lights.size(), 1U); // in the middle of the map
  EXPECT_LT(glm::distance(glm::dvec3(lights[0].position), direction(map, 64 * 15 + 31)), 1e-6);
}

TEST(EnvironmentLights, have_the_same_bits_each_time_and_on_every_machine) {
  EXPECT_TRUE(test::same_bits(lights_of(sunny_map(), 300), lights_of(sunny_map(), 300)));
  const LightSet lights = lights_of(sunny_map(), 300);
  EXPECT_EQ(lights[17].position, glm::vec3(0x1.d563a8p-4F, -0x1.f06192p-1F, -0x1.bbc044p-3F));
  EXPECT_EQ(lights[17].intensity, glm::vec3(0x1.3561c2p-6F, 0x1.32193cp-6F, 0x1.2ed0b6p-6F));
}

TEST(EnvironmentLights, are_added_and_noted) {
  Scene scene;
  scene.lights.add_omni({0, 1, 0}, glm::vec3(1));
  EnvironmentMap map = grey_map({8, 4}, 1);
  map.notes = {"sky: odd"};
  add_environment_lights(scene, map, {.count = 20});
  EXPECT_EQ(scene.lights.size(), 21U);
  EXPECT_THAT(scene.notes,
              testing::ElementsAre("sky: odd", "20 directional lights from sky, 12.57 W/m^2 from "
                                               "all directions"));
}

TEST(EnvironmentLights, refuse_what_they_cannot_do_and_leave_the_scene_alone) {
  const auto refuses = [](const std::string& part, const EnvironmentMap& map, std::uint32_t count) {
    Scene scene;
    expect_refusal(part, [&] { add_environment_lights(scene, map, {.count = count}); });
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(scene.notes.empty());
  };
  refuses("environment lights: count is 0, expected 1 to 10000000", grey_map({8, 4}, 1), 0);
  refuses("sky: 0 pixels for 0 x 0", grey_map({0, 0}, 1), 5);
  EnvironmentMap bad = grey_map({8, 4}, 1);
  bad.radiance[13].b = -1;
  refuses("sky: pixel (5, 1): b is -1, negative", bad, 5);
  refuses("sky: light 0: irradiance.r is inf", grey_map({8, 4}, 3e38F), 1);
}

} // namespace
} // namespace lightcuts
