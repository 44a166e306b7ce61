// SPDX-License-Identifier: MIT
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/oracle/support/made_draws.h>

namespace lightcuts::oracle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

// What the documentation of sample() allows: where a light cannot contribute, none is drawn.
TEST(SamplingProperties, AllowDrawingNoneWhereALightIsDark) {
  LightSet lights;
  lights.add_omni({0, 0, 1}, glm::vec3(1));
  lights.add_omni({0, 0, -1}, glm::vec3(1));
  const JudgedPoint judged(build(lights), diffuse_point(), {1, 1});
  EXPECT_THAT(violated(probabilities_of(own(judged), judged)), IsEmpty());
  const MadeDraws half(judged.tree, {.drawn = [](auto, DrawnLight& d) { d.probability *= 0.5; },
                                     .probability = [](auto, auto, double p) { return p / 2; }});
  EXPECT_THAT(violated(probabilities_of(MadeDraws(half), judged)),
              ElementsAre(Property::probabilities_sum_to_one)); // of the leaf that shines
}

TEST_F(FourLights, ConvictADrawThatStatesAnotherProbability) {
  for (const double by : {1.01, 1 + 0x1p-50, 0.5, not_a_number}) {
    const Changes changes{.drawn = [by](auto, DrawnLight& d) { d.probability *= by; }};
    EXPECT_THAT(violated(probabilities_of(with(changes), judged)),
                ElementsAre(Property::draws_state_their_probability))
        << by;
  }
}

TEST_F(FourLights, ConvictADrawFromElsewhere) {
  const std::uint32_t a = nodes(cut_of(2))[0];
  const std::uint32_t other = judged.topology.all_lights(nodes(cut_of(2))[1])[0];
  const Changes changes{.drawn = [&](std::uint32_t node, DrawnLight& d) {
    if (node == a) d.light = other;
  }};
  EXPECT_THAT(violated(probabilities_of(with(changes), judged)),
              ElementsAre(Property::draws_state_their_probability));
}

/// One of a cluster's two lights, never drawn.
Changes without_one(std::uint32_t cluster, std::uint32_t dead, std::uint32_t other) {
  return {.drawn =
              [=](std::uint32_t node, DrawnLight& d) {
                if (node == cluster) d = {other, 1};
              },
          .probability =
              [=](std::uint32_t node, std::uint32_t light, double p) {
                if (node != cluster) return p;
                return light == dead ? 0.0 : 1.0;
              }};
}

TEST_F(FourLights, ConvictASamplerThatForgetsALight) {
  const std::uint32_t cluster = nodes(cut_of(2))[0];
  const std::span<const std::uint32_t> lights = judged.topology.all_lights(cluster);
  ASSERT_EQ(lights.size(), 2U);
  Changes changes = without_one(cluster, lights[0], lights[1]);
  EXPECT_THAT(violated(probabilities_of(with(changes), judged)),
              ElementsAre(Property::contributing_lights_are_drawn));
  const Wide f = contribution(judged.tree.lights()[lights[1]], judged.point, 0);
  changes.clusters = [=](Clusters& all, std::uint64_t) {
    for (CutCluster& c : all)
      if (c.node == cluster) c.estimate = glm::dvec3(f[0], f[1], f[2]);
  };
  EXPECT_THAT(violated(draws_of(with(changes), judged, cut_of(2))),
              Contains(Property::stochastic_is_unbiased));
}

/// All probabilities below 1 times that, stated as they are.
Changes scaled_probabilities(double by) {
  return {.drawn = [by](auto, DrawnLight& d) { d.probability *= d.probability < 1 ? by : 1; },
          .probability = [by](auto, auto, double p) { return p < 1 ? p * by : p; }};
}

TEST_F(FourLights, ConvictProbabilitiesThatDoNotSumToOne) {
  for (const double by : {1 + 0x1p-40, 1 - 0x1p-40, 1.01, 0.99})
    EXPECT_THAT(violated(probabilities_of(with(scaled_probabilities(by)), judged)),
                ElementsAre(Property::probabilities_sum_to_one))
        << by;
}

TEST_F(FourLights, ConvictProbabilitiesThatAreNone) {
  for (const double wrong : {not_a_number, -0.25, 1.25, double(INFINITY)}) {
    const Changes changes{
        .probability = [wrong](auto, auto, double p) { return p < 1 ? wrong : p; }};
    EXPECT_THAT(violated(probabilities_of(with(changes), judged)),
                Contains(Property::results_are_finite))
        << wrong;
  }
}

} // namespace
} // namespace lightcuts::oracle
