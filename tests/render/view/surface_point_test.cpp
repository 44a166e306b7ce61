// SPDX-License-Identifier: MIT
#include <lightcuts/render/view/surface_point.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

TriangleMesh triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  TriangleMesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  mesh.surface = {0};
  return mesh;
}

TriangleMesh right_triangle() { return triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}); }

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(SurfacePoint, interpolates_the_position) {
  const SurfacePoint at = surface_point(right_triangle(), {0, {0.25F, 0.5F}, 1}, {0, 0, -1});
  EXPECT_EQ(at.position, glm::vec3(0.25F, 0.5F, 0));
}

TEST(SurfacePoint, has_normals_towards_the_viewer) {
  TriangleMesh mesh = right_triangle();
  mesh.normals.assign(3, glm::normalize(glm::vec3(1, 0, 2)));
  for (const float side : {1.0F, -1.0F}) {
    const SurfacePoint at = surface_point(mesh, {0, {0.25F, 0.5F}, 1}, {0, 0, -side});
    EXPECT_EQ(at.geometric_normal, glm::vec3(0, 0, side));
    EXPECT_EQ(at.shading_normal, side * mesh.normals[0]);
    EXPECT_GT(side * at.ray_origin.z, 0);
    EXPECT_LT(side * at.ray_origin.z, 1e-5F);
  }
}

TEST(SurfacePoint, interpolates_normals_and_normalises_them) {
  TriangleMesh mesh = right_triangle();
  mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const glm::vec3 n = surface_point(mesh, {0, {0.25F, 0.25F}, 1}, {-1, -1, -1}).shading_normal;
  EXPECT_LT(glm::distance(n, glm::normalize(glm::vec3(2, 1, 1))), 1e-6F);
}

TEST(SurfacePoint, falls_back_to_the_face) {
  const auto shading = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& view) {
    TriangleMesh mesh = right_triangle();
    mesh.normals = {a, b, b};
    return surface_point(mesh, {0, {0.25F, 0.25F}, 1}, view).shading_normal;
  };
  const glm::vec3 up(0, 0, 1);
  EXPECT_EQ(shading({0, 0, 0}, {1, 0, 0}, -up), up) << "a vertex without a normal";
  EXPECT_EQ(shading({1, 0, 0}, {-1, 0, 0}, -up), up) << "normals that cancel out";
  const glm::vec3 slanted = glm::normalize(glm::vec3(1, 0, 0.1F));
  EXPECT_EQ(shading(slanted, slanted, {1, 0, -0.2F}), up) << "a normal away from the viewer";
  EXPECT_LT(glm::distance(shading(slanted, slanted, {-1, 0, -0.2F}), slanted), 1e-6F);
}

TEST(SurfacePoint, is_never_NaN) {
  const glm::vec3 far(3e38F, 3e38F, -3e38F), tiny(1e-45F, 0, 0), y(0, 1e-45F, 0);
  for (const TriangleMesh& mesh :
       {triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),
        triangle(far, -far, {3e38F, 0, 0}), triangle({0, 0, 0}, tiny, y)})
    for (const glm::vec3 view : {glm::vec3(1, 2, 3), {1e-45F, 0, 0}, {0, 3e38F, 0}}) {
      const SurfacePoint at = surface_point(mesh, {0, {0.3F, 0.3F}, 1}, view);
      EXPECT_TRUE(is_finite(at.position) && is_finite(at.ray_origin));
      EXPECT_NEAR(glm::length(at.geometric_normal), 1, 1e-6);
      EXPECT_NEAR(glm::length(at.shading_normal), 1, 1e-6);
      EXPECT_LE(glm::dot(glm::dvec3(at.geometric_normal), glm::dvec3(view)), 0);
    }
}

struct Randomness {
  std::mt19937 engine{7};
  float operator()(float lo, float hi) {
    return std::uniform_real_distribution<float>(lo, hi)(engine);
  }
  glm::vec3 vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
};

// A triangle down to 1:500 in shape, of any size, anywhere up to 1e8 of its size away.
TriangleMesh random_triangle(Randomness& random) {
  const float size = std::exp2(random(-60, 60));
  const float distance = size * std::exp2(random(-10, 27));
  const glm::vec3 a = distance * random.vector(), e = random.vector();
  const glm::vec3 across = glm::normalize(glm::cross(e, random.vector())) * glm::length(e);
  const float height = std::exp2(random(-9, 0));
  return triangle(a, a + size * e, a + size * (random(0, 1) * e + height * across));
}

// How thin the rounded triangle is: its height over its longest side.
double shape(const TriangleMesh& mesh) {
  const glm::dvec3 a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  return longest > 0 ? glm::length(glm::cross(b - a, c - a)) / (longest * longest) : 0;
}

TEST(SurfacePoint, starts_rays_that_never_meet_their_own_triangle) {
  Randomness random;
  int tested = 0;
  for (int i = 0; i < 20000; ++i) {
    const TriangleMesh mesh = random_triangle(random);
    if (shape(mesh) < 0x1p-10) continue;
    const Occluder occluder(mesh);
    for (int k = 0; k < 20; ++k) {
      const float u = random(0, 1), v = random(0, 1);
      const SurfacePoint at = surface_point(
          mesh, {0, {std::min(u, 1 - u), v * (1 - std::min(u, 1 - u))}, 1}, random.vector());
      // Lights from straight above to grazing, near and far.
      glm::vec3 direction = glm::normalize(random.vector());
      const float side = glm::dot(direction, at.geometric_normal);
      direction += (std::exp2(random(-30, 0)) - side) * at.geometric_normal;
      const float reach = glm::distance(mesh.positions[0], mesh.positions[1]);
      const ShadowRay ray{at.ray_origin, direction * (reach * std::exp2(random(-10, 20))), 1};
      if (glm::dot(glm::dvec3(ray.direction), glm::dvec3(at.geometric_normal)) <= 0) continue;
      ++tested;
      ASSERT_FALSE(occluder.occluded(ray)) << "triangle " << i << " ray " << k;
    }
  }
  EXPECT_GT(tested, 100000);
}

TEST(SurfacePoint, starts_rays_close_to_the_surface) {
  const float ulp = 8; // at 1e8
  const glm::vec3 offset(1e8F, -1e8F, 1e8F);
  const TriangleMesh mesh =
      triangle(offset, offset + glm::vec3(1e4F, 0, 1e4F), offset + glm::vec3(0, 1e4F, 0));
  const SurfacePoint at = surface_point(mesh, {0, {0.3F, 0.3F}, 1}, {-1, 0, 1});
  EXPECT_LE(glm::distance(at.ray_origin, at.position), 2 * ulp);
  const SurfacePoint near =
      surface_point(right_triangle(), {0, {0.3F, 0.3F}, 1}, glm::vec3(0, 0, -1));
  EXPECT_LE(glm::distance(near.ray_origin, near.position), 1e-5F);
}

} // namespace
} // namespace lightcuts
