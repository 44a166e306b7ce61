// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/occluder.h>

#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <xmmintrin.h>

namespace lightcuts {
namespace {

// Two squares, [0,1] x [0,1] at z = 0 (triangles 0, 1) and at z = -1 (2, 3).
TriangleMesh squares() {
  TriangleMesh mesh;
  for (const float z : {0.0F, -1.0F}) {
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const glm::vec2 p : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
      mesh.positions.emplace_back(p.x, p.y, z);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
  }
  mesh.surface.assign(4, 0);
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, float factor) {
  for (glm::vec3& p : mesh.positions) p *= factor;
  return mesh;
}

TEST(Occluder, finds_the_nearest_triangle) {
  const Occluder occluder(squares());
  const auto hit = occluder.intersect({0.75F, 0.25F, 3}, {0, 0, -2});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 0U);
  EXPECT_EQ(hit->distance, 1.5F);
  EXPECT_NEAR(hit->barycentric.x, 0.5F, 1e-6); // (0.75, 0.25) = 0.25 a + 0.5 b + 0.25 c
  EXPECT_NEAR(hit->barycentric.y, 0.25F, 1e-6);
  const auto behind = occluder.intersect({0.25F, 0.75F, -0.5F}, {0, 0, -1});
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->triangle, 3U);
}

TEST(Occluder, misses_what_lies_beside_or_behind) {
  const Occluder occluder(squares());
  EXPECT_FALSE(occluder.intersect({2, 0.5F, 3}, {0, 0, -1}));
  EXPECT_FALSE(occluder.intersect({0.5F, 0.5F, 3}, {0, 0, 1}));
  EXPECT_FALSE(occluder.intersect({0.5F, 0.5F, 3}, {0, 0, 0}));
}

TEST(Occluder, blocks_between_the_ends_only) {
  const Occluder occluder(squares());
  const glm::vec3 below(0.4F, 0.3F, -0.5F), above(0.6F, 0.4F, 0.5F), higher(0.6F, 0.4F, 2);
  EXPECT_TRUE(occluder.occluded(shadow_ray(below, above)));
  EXPECT_TRUE(occluder.occluded(shadow_ray(above, below)));
  EXPECT_FALSE(occluder.occluded(shadow_ray(above, higher)));
  EXPECT_FALSE(occluder.occluded(shadow_ray(above, above)));
}

TEST(Occluder, lets_light_on_a_surface_shine_off_it) {
  const Occluder occluder(squares());
  const glm::vec3 light(0.3F, 0.6F, 0);
  EXPECT_FALSE(occluder.occluded(shadow_ray({0.5F, 0.5F, 2}, light)));
  EXPECT_FALSE(occluder.occluded(shadow_ray({0.5F, 0.5F, -0.7F}, light)));
  EXPECT_TRUE(occluder.occluded(shadow_ray({0.5F, 0.5F, 2}, light - glm::vec3(0, 0, 1e-3F))));
}

TEST(Occluder, gives_the_same_answers_at_any_power_of_two) {
  const Occluder unit(squares());
  const glm::vec3 from(0.1F, 0.2F, 1.3F), towards(0.3F, 0.1F, -0.9F);
  const auto expected = unit.intersect(from, towards);
  ASSERT_TRUE(expected);
  for (int e = -100; e <= 100; e += 20) {
    const float s = std::ldexp(1.0F, e);
    const Occluder occluder(scaled(squares(), s));
    const auto hit = occluder.intersect(s * from, towards);
    ASSERT_TRUE(hit) << e;
    EXPECT_EQ(hit->triangle, expected->triangle);
    EXPECT_EQ(hit->distance, s * expected->distance);
    EXPECT_EQ(hit->barycentric, expected->barycentric);
    EXPECT_TRUE(occluder.occluded(shadow_ray(s * from, s * (from + 2.0F * towards))));
    EXPECT_FALSE(occluder.occluded(shadow_ray(s * from, s * (from + towards))));
  }
}

TEST(Occluder, ignores_triangles_without_area) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0.1F, 0.3F, 0.7F}, {0.2F, 0.6F, 1.4F}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {1, 1, 1}, {0, 3, 4}};
  mesh.surface.assign(4, 0);
  const Occluder occluder(mesh);
  for (int i = 0; i < 1000; ++i) {
    const float x = static_cast<float>(i) / 500;
    const glm::vec3 on = i % 2 == 0 ? glm::vec3(x, x, 0) : x / 4 * mesh.positions[4];
    EXPECT_FALSE(occluder.intersect(on + glm::vec3(0.3F, -0.2F, 1), {-0.3F, 0.2F, -1})) << i;
    EXPECT_FALSE(occluder.occluded({on + glm::vec3(0, 0, 1), {0, 0, -1}, 2})) << i;
  }
}

TEST(Occluder, of_nothing_blocks_nothing) {
  const Occluder occluder(TriangleMesh{});
  EXPECT_FALSE(occluder.intersect({0, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(occluder.occluded(shadow_ray({0, 0, 0}, {1, 0, 0})));
}

TEST(Occluder, can_be_moved_and_outlives_its_mesh) {
  auto mesh = std::make_unique<TriangleMesh>(squares());
  Occluder first(*mesh);
  mesh.reset();
  const Occluder second(std::move(first));
  EXPECT_TRUE(second.intersect({0.5F, 0.25F, 1}, {0, 0, -1}));
}

TEST(Occluder, answers_many_threads) {
  const Occluder occluder(squares());
  std::vector<std::thread> threads;
  std::vector<int> blocked(4);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 1000; ++i)
        blocked[t] += occluder.occluded({{static_cast<float>(i) / 500, 0.3F, 1}, {0, 0, -1}, 2});
    });
  for (std::thread& thread : threads) thread.join();
  for (const int count : blocked) EXPECT_EQ(count, blocked[0]);
  EXPECT_NEAR(blocked[0], 501, 1);
}

TEST(Occluder, leaves_subnormals_alone_and_prints_nothing) {
  const unsigned before = _mm_getcsr() & ~static_cast<unsigned>(_MM_EXCEPT_MASK);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Occluder occluder(squares());
  EXPECT_TRUE(occluder.intersect({0.5F, 0.25F, 1}, {0, 0, -1}));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(_mm_getcsr() & ~static_cast<unsigned>(_MM_EXCEPT_MASK), before);
  volatile float tiny = 1e-38F;
  EXPECT_GT(tiny / 16, 0);
}

TEST(Occluder, refuses_broken_meshes) {
  TriangleMesh mesh = squares();
  mesh.positions[5].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Occluder{mesh}, InputError);
  mesh = squares();
  mesh.triangles[1].z = 8;
  EXPECT_THROW(Occluder{mesh}, InputError);
}

TEST(ShadowRay, stops_short_of_the_light) {
  const ShadowRay ray = shadow_ray({1, 2, 3}, {2, 4, 7});
  EXPECT_EQ(ray.direction, glm::vec3(1, 2, 4));
  EXPECT_EQ(ray.far, 1 - 0x1p-14F);
}

TEST(ShadowRay, stays_finite_across_the_range_of_float) {
  const ShadowRay ray = shadow_ray({-3e38F, 0, 0}, {3e38F, 0, 0});
  EXPECT_EQ(ray.direction, glm::vec3(3e38F, 0, 0));
  EXPECT_EQ(ray.far, 2 * (1 - 0x1p-14F));
}

} // namespace
} // namespace lightcuts
