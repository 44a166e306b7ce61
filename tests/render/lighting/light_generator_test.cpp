// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/light_generator.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <tests/render/support/refusal.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

LightCloud cloud_of(std::uint32_t count) {
  return {count, 7, {-1, 2, 3}, {1, 4, 8}, {30, 20, 10}, false};
}

LightSet lights_of(const LightCloud& cloud) {
  LightSet lights;
  generate(cloud, lights);
  return lights;
}

bool equal(const LightSet& a, const LightSet& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

TEST(LightGenerator, makes_the_lights_asked_for_within_the_box) {
  const LightCloud cloud = cloud_of(1000);
  const LightSet lights = lights_of(cloud);
  ASSERT_EQ(lights.size(), 1000U);
  for (const Light& light : lights)
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(light.position[axis], cloud.lo[axis]);
      EXPECT_LE(light.position[axis], cloud.hi[axis]);
    }
}

TEST(LightGenerator, spreads_the_lights_evenly_over_the_box) {
  const LightCloud cloud = cloud_of(8000);
  int octants[8] = {};
  for (const Light& light : lights_of(cloud)) {
    int octant = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (2 * light.position[axis] > cloud.lo[axis] + cloud.hi[axis]) octant |= 1 << axis;
    ++octants[octant];
  }
  // 1000 expected, standard deviation 30; fixed seed.
  for (const int count : octants) EXPECT_NEAR(count, 1000, 150);
}

TEST(LightGenerator, splits_the_total_intensity) {
  for (const bool colours : {false, true})
    for (const std::uint32_t count : {1U, 10U, 5000U}) {
      LightCloud cloud = cloud_of(count);
      cloud.random_colours = colours;
      glm::dvec3 sum{0};
      for (const Light& light : lights_of(cloud)) sum += glm::dvec3(light.intensity);
      // Each light's intensity is rounded once, by at most 2^-24 of itself.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / double(cloud.intensity[c]), 1, 0x1p-23);
    }
}

TEST(LightGenerator, weights_the_lights_at_random_and_tints_them_if_asked) {
  LightCloud cloud = cloud_of(500);
  cloud.intensity = glm::vec3(1);
  std::set<float> strengths;
  for (const Light& light : lights_of(cloud)) {
    EXPECT_EQ(light.intensity.r, light.intensity.g);
    EXPECT_EQ(light.intensity.r, light.intensity.b);
    strengths.insert(light.intensity.r);
  }
  EXPECT_GT(strengths.size(), 490U);
  EXPECT_LE(*strengths.rbegin(), 3.001F * *strengths.begin());
  cloud.random_colours = true;
  const LightSet coloured = lights_of(cloud);
  EXPECT_GT(std::count_if(coloured.begin(), coloured.end(),
                          [](const Light& l) { return l.intensity.r != l.intensity.g; }),
            490);
}

TEST(LightGenerator, gives_the_same_bits_for_the_same_seed) {
  LightCloud cloud = cloud_of(100);
  EXPECT_TRUE(equal(lights_of(cloud), lights_of(cloud)));
  const LightSet before = lights_of(cloud);
  cloud.seed = 8;
  EXPECT_FALSE(equal(before, lights_of(cloud)));
}

TEST(LightGenerator, gives_these_bits_on_every_machine) {
  const LightSet lights = lights_of(cloud_of(3));
  EXPECT_EQ(lights[2].position, glm::vec3(-0x1.ffafcp-4F, 0x1.b5e81p+1F, 0x1.e79fb8p+2F));
  EXPECT_EQ(lights[2].intensity, glm::vec3(0x1.374ccep+3F, 0x1.9f1112p+2F, 0x1.9f1112p+1F));
}

TEST(LightGenerator, adds_to_what_is_there) {
  LightSet lights;
  generate(cloud_of(3), lights);
  generate(cloud_of(2), lights);
  EXPECT_EQ(lights.size(), 5U);
}

TEST(LightGenerator, takes_extreme_boxes) {
  LightCloud cloud = cloud_of(100);
  cloud.lo = glm::vec3(-3e38F);
  cloud.hi = glm::vec3(3e38F);
  EXPECT_EQ(lights_of(cloud).size(), 100U);
  cloud.lo = cloud.hi = {1, 2, 3};
  for (const Light& light : lights_of(cloud)) EXPECT_EQ(light.position, cloud.lo);
}

TEST(LightGenerator, refuses_what_leaves_the_domain) {
  const auto refuses = [](const std::string& part, auto&& change) {
    LightCloud cloud = cloud_of(10);
    change(cloud);
    expect_refusal(part, [&] { lights_of(cloud); });
  };
  refuses("light cloud: count is 0", [](auto& c) { c.count = 0; });
  refuses("count is 4294967295", [](auto& c) { c.count = 4294967295U; });
  refuses("lo.y is nan", [&](auto& c) { c.lo.y = nan; });
  refuses("hi.z is inf", [&](auto& c) { c.hi.z = inf; });
  refuses("lo.x is 5, greater than hi", [](auto& c) { c.lo.x = 5; });
  refuses("intensity.g is -1, negative", [](auto& c) { c.intensity.g = -1; });
  refuses("intensity.b is nan", [&](auto& c) { c.intensity.b = nan; });
}

TEST(LightGenerator, refuses_without_adding_a_light) {
  LightCloud cloud = cloud_of(10);
  cloud.intensity.r = -1;
  LightSet lights;
  EXPECT_THROW(generate(cloud, lights), InputError);
  EXPECT_TRUE(lights.empty());
}

TriangleMesh unit_box_corners(float scale) {
  TriangleMesh mesh;
  mesh.positions = {glm::vec3(0), scale * glm::vec3(1, 1, 0), scale * glm::vec3(0, 1, 1)};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(DefaultCloud, fills_the_upper_half_off_the_walls) {
  const LightCloud cloud = default_cloud(unit_box_corners(10), 50, 3);
  EXPECT_EQ(cloud.count, 50U);
  EXPECT_EQ(cloud.seed, 3U);
  for (const int axis : {0, 2}) {
    EXPECT_FLOAT_EQ(cloud.lo[axis], 0.5F);
    EXPECT_FLOAT_EQ(cloud.hi[axis], 9.5F);
  }
  EXPECT_FLOAT_EQ(cloud.lo.y, 5);
  EXPECT_FLOAT_EQ(cloud.hi.y, 9.5F);
}

TEST(DefaultCloud, has_an_intensity_that_does_not_depend_on_the_count_and_grows_with_the_area) {
  const float one = default_cloud(unit_box_corners(1), 50, 3).intensity.r;
  EXPECT_EQ(one, default_cloud(unit_box_corners(1), 5000, 3).intensity.r);
  EXPECT_FLOAT_EQ(16 * one, default_cloud(unit_box_corners(4), 50, 3).intensity.r);
}

TEST(DefaultCloud, is_valid_for_flat_and_for_huge_meshes) {
  TriangleMesh flat;
  flat.positions = {{0, 0.1F, 0}, {1, 0.1F, 0}, {0, 0.1F, 1}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_EQ(lights_of(default_cloud(flat, 5, 1)).size(), 5U);
  EXPECT_EQ(lights_of(default_cloud(unit_box_corners(3e38F), 5, 1)).size(), 5U);
}

TEST(DefaultCloud, hangs_above_a_flat_mesh_not_in_it) {
  TriangleMesh flat;
  flat.positions = {{0, 0.1F, 0}, {1, 0.1F, 0}, {0, 0.1F, 1}};
  flat.triangles = {{0, 1, 2}};
  for (const Light& light : lights_of(default_cloud(flat, 5, 1)))
    EXPECT_GT(light.position.y, 0.3F); // a quarter of the diagonal above 0.1
}

TEST(DefaultCloud, refuses_a_mesh_without_triangles) {
  expect_refusal("no triangles", [] { (void)default_cloud({}, 5, 1); });
}

} // namespace
} // namespace lightcuts
