// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/shapes/shape_lights.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/records/fields.h>

namespace lightcuts {
namespace {

using std::numbers::pi;

ShapeLights shape_of(ShapeKind kind) {
  return {.kind = kind,
          .centre = {1, 2, 3},
          .axis = {0, -0.6F, 0.8F},
          .along = {1, 0, 0},
          .sides = {2, 0.5F},
          .radius = 0.75F,
          .length = 3,
          .radiance = {1, 0.3F, 7e-5F},
          .count = 777};
}

LightSet lights_of(const ShapeLights& shape) {
  Scene scene;
  add_shape_lights(scene, shape);
  return scene.lights;
}

class ShapeLightsOf : public testing::TestWithParam<ShapeKind> {};
INSTANTIATE_TEST_SUITE_P(EveryShape, ShapeLightsOf,
                         testing::Values(ShapeKind::rectangle, ShapeKind::disc, ShapeKind::sphere,
                                         ShapeKind::tube),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST_P(ShapeLightsOf, SendTheStatedPowerButForTheRoundingOfOneLight) {
  for (const std::uint32_t count : {1U, 3U, 777U, 100'000U}) {
    ShapeLights shape = shape_of(GetParam());
    shape.count = count;
    const LightSet lights = lights_of(shape);
    ASSERT_EQ(lights.size(), count);
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (const Light& light : lights) sum += light.intensity[c];
      const double total = area_of(shape) * shape.radiance[c];
      // Half a step of the last float; and the sum here and there in doubles.
      EXPECT_NEAR(sum, total, total / count * 0x1p-24 + total * count * 0x1p-52) << count;
    }
  }
}

TEST_P(ShapeLightsOf, AreAlikeButForOneStepOfAFloat) {
  const LightSet lights = lights_of(shape_of(GetParam()));
  for (const Light& light : lights)
    EXPECT_NEAR(light.intensity.x, lights[0].intensity.x, lights[0].intensity.x * 0x1p-22);
}

TEST_P(ShapeLightsOf, HaveTheSameBitsEachTimeAndOthersByAnotherSeed) {
  ShapeLights shape = shape_of(GetParam());
  const LightSet one = lights_of(shape), again = lights_of(shape);
  shape.seed = 2;
  const LightSet other = lights_of(shape);
  bool differs = false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i], again[i]);
    differs = differs || one[i] != other[i];
  }
  EXPECT_TRUE(differs);
}

// Its mean place is its centre, as near as 777 points that are spread evenly come.
TEST_P(ShapeLightsOf, AreSpreadEvenly) {
  glm::dvec3 mean(0);
  const LightSet lights = lights_of(shape_of(GetParam()));
  for (const Light& light : lights) mean += glm::dvec3(light.position) / double(lights.size());
  EXPECT_LT(glm::distance(mean, glm::dvec3(1, 2, 3)), 0.01);
}

TEST_P(ShapeLightsOf, RefuseWhatIsNoShape) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refuses = [&](auto&& spoil) {
    ShapeLights shape = shape_of(GetParam());
    spoil(shape);
    Scene scene;
    try {
      add_shape_lights(scene, shape);
    } catch (const InputError&) {
      return scene.lights.empty();
    }
    return false;
  };
  EXPECT_TRUE(refuses([](ShapeLights& s) { s.count = 0; }));
  EXPECT_TRUE(refuses([](ShapeLights& s) { s.radiance.y = -1; }));
  EXPECT_TRUE(refuses([&](ShapeLights& s) { s.radiance.y = nan; }));
  EXPECT_TRUE(refuses([](ShapeLights& s) {
    s.radiance.y = 3e38F;
    s.sides = glm::vec2(1e3F);
    s.radius = 1e3F;
    s.count = 1;
  }));
  const bool flat = GetParam() == ShapeKind::rectangle;
  EXPECT_EQ(refuses([](ShapeLights& s) { s.sides.y = 0; }), flat);
  EXPECT_EQ(refuses([](ShapeLights& s) { s.along = {0, 0.6F, -0.8F}; }), flat);
  EXPECT_EQ(refuses([](ShapeLights& s) { s.radius = -1; }), !flat);
  EXPECT_EQ(refuses([](ShapeLights& s) { s.length = 0; }), GetParam() == ShapeKind::tube);
}

TEST(ShapeLights, LieOnTheirShapesAndFaceOutwards) {
  const glm::dvec3 centre(1, 2, 3), axis = glm::normalize(glm::dvec3(0, -0.6F, 0.8F));
  for (const Light& light : lights_of(shape_of(ShapeKind::rectangle))) {
    const glm::dvec3 d = glm::dvec3(light.position) - centre;
    EXPECT_NEAR(glm::dot(d, axis), 0, 1e-6);
    EXPECT_LE(std::abs(d.x), 1);
    EXPECT_LE(glm::length(d - glm::dvec3(d.x, 0, 0)), 0.2500001);
    EXPECT_EQ(light.axis, glm::vec3(axis));
  }
  for (const Light& light : lights_of(shape_of(ShapeKind::disc))) {
    const glm::dvec3 d = glm::dvec3(light.position) - centre;
    EXPECT_NEAR(glm::dot(d, axis), 0, 1e-6);
    EXPECT_LE(glm::length(d), 0.7500001);
    EXPECT_EQ(light.axis, glm::vec3(axis));
  }
  for (const Light& light : lights_of(shape_of(ShapeKind::sphere)))
    EXPECT_LT(glm::distance(glm::dvec3(light.position), centre + 0.75 * glm::dvec3(light.axis)),
              1e-6);
  for (const Light& light : lights_of(shape_of(ShapeKind::tube))) {
    const glm::dvec3 d = glm::dvec3(light.position) - centre;
    const double height = glm::dot(d, axis);
    EXPECT_LE(std::abs(height), 1.5000001);
    EXPECT_LT(glm::distance(d, height * axis + 0.75 * glm::dvec3(light.axis)), 1e-6);
    EXPECT_NEAR(glm::dot(glm::dvec3(light.axis), axis), 0, 1e-6);
  }
}

/// Irradiance at x of a surface that faces n.
double irradiance(const LightSet& lights, const glm::dvec3& x, const glm::dvec3& n) {
  double sum = 0;
  for (const Light& light : lights) {
    const glm::dvec3 q = glm::dvec3(light.position) - x;
    const double d2 = glm::dot(q, q), d = std::sqrt(d2);
    sum += light.intensity.x * std::max(0.0, glm::dot(n, q) / d) *
           std::max(0.0, -glm::dot(glm::dvec3(light.axis), q) / d) / d2;
  }
  return sum;
}

// pi L (r/d)^2: of a sphere whose centre is d away, and of a disc on whose axis x is, with
// d^2 = h^2 + r^2.
TEST(ShapeLights, LightSurfacesLikeTheirShapes) {
  ShapeLights sphere = shape_of(ShapeKind::sphere);
  sphere.count = 4000;
  const glm::dvec3 n(0, 1, 0), below = glm::dvec3(1, 2, 3) - 2.0 * n;
  EXPECT_NEAR(irradiance(lights_of(sphere), below, n), pi * 0.75 * 0.75 / 4, 2e-3);
  ShapeLights disc = shape_of(ShapeKind::disc);
  disc.axis = {0, -1, 0};
  disc.count = 4000;
  EXPECT_NEAR(irradiance(lights_of(disc), below, n), pi * 0.5625 / (4 + 0.5625), 2e-3);
}

} // namespace
} // namespace lightcuts
