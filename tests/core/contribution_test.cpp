// SPDX-License-Identifier: MIT
#include <lightcuts/contribution.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/generators.h"
#include "../support/precise.h"

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;

RC_GTEST_PROP(Transfer, KeepsToTheStatedError, ()) {
  const gen::Scene scene = *gen::scene();
  const ShadingPoint point = scene.view.point();
  for (const OmniLight& light : scene.lights) {
    const Colour exact = precise::transfer(point, light.position);
    const glm::dvec3 value = transfer(point, light.position);
    for (int c = 0; c < 3; ++c) {
      // The domain of the stated error; below it, absolute: the lobe may underflow.
      if (exact[c] < Quad(1e-150)) {
        RC_ASSERT(value[c] >= 0);
        RC_ASSERT(Quad(value[c]) <= Quad(1e-150) * (1 + transfer_error));
      } else {
        RC_ASSERT(abs(Quad(value[c]) - exact[c]) <= exact[c] * transfer_error);
      }
    }
  }
}

RC_GTEST_PROP(Transfer, IsZeroFromBelowTheHorizon, ()) {
  const gen::Scene scene = *gen::scene();
  const ShadingPoint point = scene.view.point();
  for (const OmniLight& light : scene.lights)
    if (precise::dot(point.normal(), point.position(), light.position) <= 0)
      RC_ASSERT(transfer(point, light.position) == glm::dvec3(0));
}

RC_GTEST_PROP(Transfer, IsZeroFromALightAtTheShadingPoint, ()) {
  const ShadingPoint point = (*gen::scene()).view.point();
  RC_ASSERT(transfer(point, point.position()) == glm::dvec3(0));
}

TEST(Transfer, OfALambertianIsAlbedoOverPiTimesCosineOverDistanceSquared) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {{1, 0.5F, 0}});
  const glm::dvec3 value = transfer(point, {0, 0, 2});
  EXPECT_DOUBLE_EQ(value.x, std::numbers::inv_pi / 4);
  EXPECT_DOUBLE_EQ(value.y, std::numbers::inv_pi / 8);
  EXPECT_EQ(value.z, 0);
}

TEST(Transfer, OfAMirrorLikeLobePeaksInTheMirrorDirection) {
  const Material phong{glm::vec3(0), glm::vec3(1), 100};
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}, phong);
  // (100 + 2) / (2 pi), cosine 0.8, distance 1. The floats 0.6 and 0.8 are off by 2^-25 or less,
  // and the lobe is flat at its top.
  EXPECT_NEAR(transfer(point, {-0.6F, 0, 0.8F}).x, 102 * 0.5 * std::numbers::inv_pi * 0.8, 1e-5);
  EXPECT_EQ(transfer(point, {0.8F, 0, 0.6F}).x, transfer(point, {0.8F, 0, 0.6F}).y);
  EXPECT_LT(transfer(point, {0.6F, 0, 0.8F}).x, 1e-50);
}

TEST(PhongNormalisation, IsThatOfLafortuneAndWillems) {
  EXPECT_DOUBLE_EQ(phong_normalisation(0), std::numbers::inv_pi);
  EXPECT_DOUBLE_EQ(phong_normalisation(2), 2 * std::numbers::inv_pi);
}

} // namespace
} // namespace lightcuts
