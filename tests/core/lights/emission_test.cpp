// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/light_kinds.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <oracle/truth/radiometry.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Quad;

/// In real numbers, by the oracle's definition.
Quad real_emission(const Light& light, const glm::vec3& x) {
  const ShadingPoint point(x, {0, 0, 1}, {0, 0, 1}, {});
  return oracle::radiometry::emission<Quad>(light, point,
                                            sqrt(Quad(precise::distance2(x, light.position))));
}

RC_GTEST_PROP(Emission, KeepsToTheStatedErrorAndItsZeroIsExact, ()) {
  const gen::Scene scene = *gen::scene();
  const glm::vec3& x = scene.view.position;
  for (const Light& light : scene.lights) {
    if (light.position == x) continue;
    const Quad exact = real_emission(light, x);
    const double value = emission(light, x);
    RC_ASSERT((value == 0) == (exact == 0));
    RC_ASSERT(abs(Quad(value) - exact) <= exact * emission_error);
  }
}

/// A spot whose outer rim passes within a few ulps of x.
TEST(Emission, OfASpotIsExactWhereItsRimPassesThroughThePoint) {
  gen::Dice dice(11);
  int dark = 0, lit = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 x = dice.in_cube();
    Light light{.kind = LightKind::spot, .position = dice.in_cube(), .axis = dice.unit_vector()};
    const glm::dvec3 d = glm::dvec3(x) - glm::dvec3(light.position);
    const double cosine = glm::dot(glm::dvec3(light.axis), d) /
                          (glm::length(d) * glm::length(glm::dvec3(light.axis)));
    // A float is within 2^-25 of it; so this finds both sides, some very near.
    light.cos_outer = float(cosine);
    light.cos_inner = light.cos_outer + std::exp2(-10.0F - float(i % 14));
    const Quad exact = real_emission(light, x);
    const double value = emission(light, x);
    EXPECT_EQ(value == 0, exact == 0);
    EXPECT_LE(abs(Quad(value) - exact), exact * emission_error);
    (value == 0 ? dark : lit) += 1;
  }
  EXPECT_GT(dark, 1000);
  EXPECT_GT(lit, 1000);
}

// cos = 1/2 at sqrt(3); the float nearest to that lies below it.
TEST(Emission, OfASpotDecidesWhatDoubleCannot) {
  const Light light{.kind = LightKind::spot,
                    .position = {0, 0, 0},
                    .axis = {0, 0, 1},
                    .cos_inner = 1,
                    .cos_outer = 0.5F};
  EXPECT_GT(emission(light, {std::sqrt(3.0F), 0, 1}), 0);
  EXPECT_EQ(emission(light, {std::nextafter(std::sqrt(3.0F), 2.0F), 0, 1}), 0);
}

TEST(Emission, OfASpotIsTheSquareOfARampBetweenTheRims) {
  const Light light{.kind = LightKind::spot,
                    .position = {0, 0, 0},
                    .axis = {0, 0, 1},
                    .cos_inner = 0.9F,
                    .cos_outer = 0.7F};
  EXPECT_EQ(emission(light, {0, 0, 1}), 1);
  EXPECT_NEAR(emission(light, {0.6F, 0, 0.8F}), 0.25, 1e-6);
  EXPECT_EQ(emission(light, {0.8F, 0, 0.6F}), 0);
}

TEST(Emission, OfAnOmniOrDirectionalLightIsAll) {
  EXPECT_EQ(emission({.kind = LightKind::omni}, {1, 2, 3}), 1);
  EXPECT_EQ(emission({.kind = LightKind::directional, .position = {0, 0, 1}}, {1, 2, 3}), 1);
}

} // namespace
} // namespace lightcuts
