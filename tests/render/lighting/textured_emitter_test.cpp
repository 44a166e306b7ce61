// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/textured_emitter.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/render/scene/triangle.h>

#include <tests/render/support/box_scene.h>

namespace lightcuts {
namespace {

/// A triangle of 3 m^2 that emits (1, 2, 4) times a texture of 5 x 3 random texels.
Scene glowing_triangle(const std::vector<glm::vec2>& uv, Wrap wrap, std::uint64_t seed) {
  Scene scene;
  scene.mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}};
  scene.mesh.normals.resize(3, glm::vec3(0));
  scene.mesh.emission_uv = uv;
  scene.mesh.triangles = {{0, 1, 2}};
  scene.mesh.surface = {0};
  scene.surfaces.push_back({"glow", {}, {1, 2, 4}});
  Random random(seed);
  std::vector<glm::vec3> texels(15);
  for (glm::vec3& t : texels) t = {random.unit(), random.unit(), random.unit()};
  scene.textures.emplace_back(glm::uvec2(5, 3), texels);
  scene.surfaces[0].emission_texture = SurfaceTexture{0, {wrap, wrap}};
  return scene;
}

glm::dvec3 radiance(const Scene& scene, const glm::dvec2& barycentric) {
  const auto& uv = scene.mesh.emission_uv;
  const glm::dvec2 at = glm::dvec2(uv[0]) * (1 - barycentric.x - barycentric.y) +
                        glm::dvec2(uv[1]) * barycentric.x + glm::dvec2(uv[2]) * barycentric.y;
  const auto& [index, wrap] = *scene.surfaces[0].emission_texture;
  return glm::dvec3(scene.surfaces[0].emission) * glm::dvec3(scene.textures[index].at(at, wrap));
}

/// Its mean at the middles of n * n equal parts, times the area.
glm::dvec3 by_quadrature(const Scene& scene, int n) {
  glm::dvec3 sum(0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n - y; ++x) {
      sum += radiance(scene, {(x + 1.0 / 3) / n, (y + 1.0 / 3) / n});
      if (x + y + 1 < n) sum += radiance(scene, {(x + 2.0 / 3) / n, (y + 2.0 / 3) / n});
    }
  return sum * (3.0 / n / n);
}

const std::vector<std::vector<glm::vec2>> placements{
    {{0, 0}, {1, 0}, {0, 1}},
    {{-0.3F, 0.2F}, {1.7F, -0.9F}, {0.4F, 2.3F}},
    {{0.41F, 0.52F}, {0.43F, 0.51F}, {0.42F, 0.53F}}, // within one texel
    {{7.1F, -3.2F}, {6.2F, -3.4F}, {6.9F, -1.8F}},    // clockwise
};

// The quadrature errs in proportion to 1/n^2: 3e-7 here at most, going by 1000 and 2000.
TEST(TexturedEmitter, has_the_integral_of_the_texture) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
    for (const auto& uv : placements) {
      const Scene scene = glowing_triangle(uv, wrap, 3);
      const TexturedEmitter emitter(scene, 0);
      EXPECT_FALSE(emitter.is_approximate());
      const glm::dvec3 expected = by_quadrature(scene, 2000);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(emitter.intensity()[c], expected[c], 3e-6 * expected[c]);
    }
}

TEST(TexturedEmitter, has_samples_that_sum_to_it) {
  for (const auto& uv : placements)
    for (const std::uint32_t count : {1U, 2U, 7U, 1000U}) {
      const Scene scene = glowing_triangle(uv, Wrap::repeat, 4);
      const TexturedEmitter emitter(scene, 0);
      glm::dvec3 sum(0);
      const auto samples = emitter.samples(count, Random(5));
      EXPECT_EQ(samples.size(), count);
      for (const auto& sample : samples) {
        sum += sample.intensity;
        EXPECT_NEAR(sample.intensity.r + sample.intensity.g + sample.intensity.b,
                    (emitter.intensity().r + emitter.intensity().g + emitter.intensity().b) / count,
                    1e-9);
        EXPECT_GE(sample.barycentric.x, 0);
        EXPECT_GE(sample.barycentric.y, 0);
        EXPECT_LE(sample.barycentric.x + sample.barycentric.y, 1 + 1e-12);
      }
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c], emitter.intensity()[c], 1e-12 * emitter.intensity()[c] * count);
    }
}

TEST(TexturedEmitter, has_samples_where_the_texture_is_bright) {
  Scene scene = glowing_triangle({{0, 0}, {1, 0}, {0, 1}}, Wrap::clamp, 1);
  std::vector<glm::vec3> texels(64, glm::vec3(0));
  texels[7 * 8 + 2] =
      glm::vec3(1); // u from 0.25 to 0.375, v from 0 to 0.125, and half a texel more
  scene.textures[0] = Texture({8, 8}, texels);
  for (const auto& sample : TexturedEmitter(scene, 0).samples(100, Random(1))) {
    EXPECT_NEAR(sample.barycentric.x, 0.3125, 0.125 + 1e-9);
    EXPECT_NEAR(sample.barycentric.y, 0.0625, 0.125 + 1e-9);
  }
}

TEST(TexturedEmitter, of_one_colour_is_exact_and_of_a_line_is_sampled) {
  const Scene point = glowing_triangle({{0.3F, 0.7F}, {0.3F, 0.7F}, {0.3F, 0.7F}}, Wrap::repeat, 2);
  const TexturedEmitter exact(point, 0);
  EXPECT_FALSE(exact.is_approximate());
  EXPECT_EQ(exact.intensity(), 3.0 * radiance(point, {0, 0}));
  const Scene line = glowing_triangle({{0, 0}, {1, 1}, {0.5F, 0.5F}}, Wrap::repeat, 2);
  const TexturedEmitter sampled(line, 0);
  EXPECT_TRUE(sampled.is_approximate());
  const glm::dvec3 expected = by_quadrature(line, 2000);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sampled.intensity()[c], expected[c], 1e-4 * expected[c]);
}

TEST(TexturedEmitter, takes_huge_textures_and_coordinates) {
  Scene scene = glowing_triangle({{0, 0}, {1, 0}, {0, 1}}, Wrap::repeat, 6);
  scene.textures[0] =
      Texture({4096, 2048}, std::vector<glm::vec3>(4096UL * 2048, glm::vec3(0.5F, 0.25F, 1)));
  const TexturedEmitter many(scene, 0);
  EXPECT_FALSE(many.is_approximate());
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(many.intensity()[c], 3 * std::exp2(c) * glm::dvec3(0.5, 0.25, 1)[c], 1e-9);
  scene.mesh.emission_uv = {{0, 0}, {1e30F, 0}, {0, 1e30F}};
  EXPECT_TRUE(TexturedEmitter(scene, 0).is_approximate());
}

} // namespace
} // namespace lightcuts
