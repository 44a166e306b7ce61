// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/transfer.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;

void check_error(const gen::Scene& scene) {
  const ShadingPoint point = scene.view.point();
  for (Light light : scene.lights) {
    light.intensity = glm::vec3(1);
    const Colour exact = precise::contribution(point, light, scene.min_distance);
    const glm::dvec3 value = transfer(point, light, scene.min_distance);
    for (int c = 0; c < 3; ++c) {
      // The domain of the stated error; below it, absolute: the lobe may underflow.
      if (exact[c] < Quad(least_transfer)) {
        RC_ASSERT(value[c] >= 0);
        RC_ASSERT(Quad(value[c]) <= Quad(least_transfer) * (1 + transfer_error));
      } else {
        RC_ASSERT(abs(Quad(value[c]) - exact[c]) <= exact[c] * transfer_error);
      }
    }
  }
}

RC_GTEST_PROP(Transfer, KeepsToTheStatedError, ()) { check_error(*gen::scene()); }
RC_GTEST_PROP(Transfer, KeepsToTheStatedErrorBetweenMirrorImagesNearTheHorizon, ()) {
  check_error(*gen::grazing_scene());
}

// 1 + l.v is next to 0, and v.h its root: what F errs by is magnified. The clamp and the far
// coordinates are those of the scene that showed it.
TEST(Transfer, KnowsFresnelsTermWhereLightAndViewerAreOpposite) {
  const Material chalk{glm::vec3(0), CookTorrance{glm::vec3(0), 1}};
  for (int e = 20; e <= 60; ++e)
    for (const float x : {0.3F, 0.45F, 0.6F, 0.7F}) {
      const float up = std::ldexp(1.0F, -e);
      const glm::vec3 v(x, up, std::sqrt(1 - double(x) * x));
      const ShadingPoint point(glm::vec3(0), {0, 1, 0}, v, chalk);
      const Light light{.position = 1e17F * glm::vec3(-v.x, v.y, -v.z), .intensity = glm::vec3(1)};
      const Quad exact = precise::contribution(point, light, 1e28F)[0];
      EXPECT_LE(abs(Quad(transfer(point, light, 1e28F).x) - exact), exact * transfer_error)
          << "n.v = 2^-" << e;
    }
}

// The normal is an axis but for the least float there is, and so is what is seen of it.
TEST(Transfer, KnowsTheTangentWhereTheNormalIsAllButAnAxis) {
  constexpr float tiny = 0x1p-149F;
  const Material glossy{glm::vec3(0), Ward{glm::vec3(1), 0.1F}};
  for (const glm::vec3& n :
       {glm::vec3(tiny, 1, 0), glm::vec3(0, 1, tiny), glm::vec3(tiny, 1, tiny)})
    for (int i = 1; i < 20; ++i) {
      const float x = 0.05F * float(i), z = std::sqrt(1 - double(x) * x);
      const ShadingPoint point(glm::vec3(0), n, {x, 3 * tiny, z}, glossy);
      const Light light{.position = {-2 * x, 6 * tiny, -2 * z}, .intensity = glm::vec3(1)};
      const Quad exact = precise::contribution(point, light)[0];
      EXPECT_GT(exact, 1e-12);
      EXPECT_LE(abs(Quad(transfer(point, light).x) - exact), exact * transfer_error);
    }
}

RC_GTEST_PROP(Transfer, IsZeroFromBelowTheHorizon, ()) {
  const gen::Scene scene = *gen::scene();
  const ShadingPoint point = scene.view.point();
  for (const Light& light : scene.lights)
    if (precise::dot(point.normal(), viewed_from(light.kind, point.position()), light.position) <=
        0)
      RC_ASSERT(transfer(point, light) == glm::dvec3(0));
}

RC_GTEST_PROP(Transfer, IsZeroFromALightAtTheShadingPoint, ()) {
  const ShadingPoint point = (*gen::scene()).view.point();
  const auto kind = LightKind(*rc::gen::inRange(0, int(LightKind::directional)));
  RC_ASSERT(transfer(point, {.kind = kind, .position = point.position(), .axis = {0, 0, 1}}) ==
            glm::dvec3(0));
}

/// Of an omni light of intensity 1.
glm::dvec3 from_omni(const ShadingPoint& point, const glm::vec3& y) {
  return transfer(point, {.position = y});
}

TEST(Transfer, OfALambertianIsAlbedoOverPiTimesCosineOverDistanceSquared) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{1, 0.5F, 0}, {}});
  const glm::dvec3 value = from_omni(point, {0, 0, 2});
  EXPECT_DOUBLE_EQ(value.x, std::numbers::inv_pi / 4);
  EXPECT_DOUBLE_EQ(value.y, std::numbers::inv_pi / 8);
  EXPECT_EQ(value.z, 0);
}

TEST(Transfer, OfAMirrorLikeLobePeaksInTheMirrorDirection) {
  const Material phong{glm::vec3(0), Phong{glm::vec3(1), 100}};
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}, phong);
  // (100 + 2) / (2 pi), cosine 0.8, distance 1. The floats 0.6 and 0.8 are off by 2^-25 or less,
  // and the lobe is flat at its top.
  EXPECT_NEAR(from_omni(point, {-0.6F, 0, 0.8F}).x, 102 * 0.5 * std::numbers::inv_pi * 0.8, 1e-5);
  EXPECT_EQ(from_omni(point, {0.8F, 0, 0.6F}).x, from_omni(point, {0.8F, 0, 0.6F}).y);
  EXPECT_LT(from_omni(point, {0.6F, 0, 0.8F}).x, 1e-50);
}

TEST(Transfer, OfAnOrientedLightHasItsCosineToo) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const Light light{.kind = LightKind::oriented, .position = {0, 0, 2}, .axis = {0.6F, 0, -0.8F}};
  EXPECT_NEAR(transfer(point, light).x, std::numbers::inv_pi / 4 * 0.8, 1e-7);
  const Light away{.kind = LightKind::oriented, .position = {0, 0, 2}, .axis = {0, 0, 1}};
  EXPECT_EQ(transfer(point, away).x, 0);
}

TEST(Transfer, OfADirectionalLightDoesNotFallOff) {
  const ShadingPoint point({5, 6, 7}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const Light light{.kind = LightKind::directional, .position = {0.6F, 0, 0.8F}};
  EXPECT_NEAR(transfer(point, light).x, std::numbers::inv_pi * 0.8, 1e-7);
}

TEST(Transfer, FallsOffNoMoreWithinTheClamp) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const Light light{.position = {0, 0, 0.25F}};
  EXPECT_DOUBLE_EQ(transfer(point, light, 0.5F).x, std::numbers::inv_pi * 4);
  EXPECT_DOUBLE_EQ(transfer(point, light, 0.125F).x, std::numbers::inv_pi * 16);
}

TEST(PhongNormalisation, IsThatOfLafortuneAndWillems) {
  EXPECT_DOUBLE_EQ((Phong{{}, 0}).normalisation(), std::numbers::inv_pi);
  EXPECT_DOUBLE_EQ((Phong{{}, 2}).normalisation(), 2 * std::numbers::inv_pi);
}

} // namespace
} // namespace lightcuts
