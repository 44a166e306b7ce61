// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/profiles/profile_light.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/kinds/luminaire.h>
#include <lightcuts/render/lighting/direction_sampling.h>

namespace lightcuts {
namespace {

Light street_light() {
  return {.kind = LightKind::profile,
          .axis = {0, -1, 0},
          .plane = {1, 0, 0},
          .profile = street_luminaire()};
}

/// Over a fine grid of cosines and turns.
double integral(const Light& light, double from_turns, double to_turns) {
  constexpr int steps = 800;
  const glm::dvec3 axis(light.axis), x(light.plane), y(glm::cross(light.plane, light.axis));
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double cosine = -1 + 2 * (i + 0.5) / steps;
      const double sine = std::sqrt(1 - cosine * cosine);
      const double angle =
          2 * std::numbers::pi * (from_turns + (to_turns - from_turns) * (k + 0.5) / steps);
      const glm::dvec3 d = cosine * axis + sine * (std::cos(angle) * x + std::sin(angle) * y);
      sum += Luminaire::emission(light, glm::vec3(d));
    }
  return sum * 4 * std::numbers::pi * (to_turns - from_turns) / (double(steps) * steps);
}

TEST(ProfileLight, SendsTheIntegralOfItsTable) {
  EXPECT_DOUBLE_EQ(solid_share({}), 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(solid_share({.cosines = {1, 0, -1}, .shares = {1, 0, 0}}), std::numbers::pi);
  const Light light = street_light();
  EXPECT_NEAR(solid_share(light.profile.table()), integral(light, 0, 1), 1e-4);
}

TEST(ProfileLight, IsDrawnInProportionToItsTable) {
  const Light light = street_light();
  const glm::dvec3 x(light.plane), y(glm::cross(light.plane, light.axis));
  constexpr int draws = 40000, sectors = 8;
  int counts[sectors] = {};
  double cosines = 0;
  Random random(5);
  for (int i = 0; i < draws; ++i) {
    const glm::dvec3 d =
        profile_direction(light, {random.unit_double(), random.unit_double()}, random);
    EXPECT_NEAR(glm::length(d), 1, 1e-12);
    ASSERT_GT(Luminaire::emission(light, glm::vec3(d)), 0);
    const double turns = std::atan2(glm::dot(d, y), glm::dot(d, x)) / (2 * std::numbers::pi);
    ++counts[int(std::floor((turns < 0 ? turns + 1 : turns) * sectors)) % sectors];
    cosines += -d.y;
  }
  const double total = solid_share(light.profile.table());
  for (int i = 0; i < sectors; ++i) {
    const double share = integral(light, double(i) / sectors, (i + 1.0) / sectors) / total;
    // Five standard deviations.
    EXPECT_NEAR(double(counts[i]) / draws, share, 5 * std::sqrt(share / draws)) << i;
  }
  EXPECT_GT(cosines / draws, 0.3);
  EXPECT_LT(cosines / draws, 0.6);
}

TEST(ProfileLight, OfNothingGoesAlongTheAxis) {
  Light light = street_light();
  light.profile = Profile({.cosines = {1, -1}, .shares = {0, 0}});
  Random random(1);
  EXPECT_EQ(profile_direction(light, {0.5, 0.5}, random), glm::dvec3(0, -1, 0));
  EXPECT_EQ(solid_share(light.profile.table()), 0);
}

TEST(ProfileLight, HasAPlaneBesideItsAxis) {
  EXPECT_EQ(*plane_beside({0, -1, 0}, {1, 0, 0}), glm::vec3(1, 0, 0));
  EXPECT_EQ(*plane_beside({0, -1, 0}, {0.6F, 0.8F, 0}), glm::vec3(1, 0, 0));
  EXPECT_FALSE(plane_beside({0, -1, 0}, {0, 1, 0}));
  EXPECT_EQ(usual_plane({0, -1, 0}), glm::vec3(1, 0, 0));
  EXPECT_EQ(usual_plane({1, 0, 0}), glm::vec3(0, 0, 1));
}

} // namespace
} // namespace lightcuts
