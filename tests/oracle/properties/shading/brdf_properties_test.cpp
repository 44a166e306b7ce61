// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <oracle/truth/reciprocity.h>
#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {
namespace {

constexpr auto reciprocal = Property::brdf_is_reciprocal;
constexpr auto energy = Property::brdf_conserves_energy;

/// Counts with one light at y, seen by a surface that faces up.
PropertyCount reciprocity_with(const Light& light, const Lobe& lobe,
                               const glm::vec3& to_viewer = {0.6F, 0, 0.8F}) {
  Tally tally;
  Judge(0, 0, tally).light({{1, 2, 3}, {0, 0, 1}, to_viewer, {glm::vec3(0.5F), lobe}}, light);
  return tally[reciprocal];
}

const std::vector<Lobe> lobes{NoLobe{}, Phong{glm::vec3(0.5F), 40}, Ward{glm::vec3(0.5F), 0.2F},
                              CookTorrance{glm::vec3(0.5F), 0.2F}};

TEST(BrdfProperties, HoldForTheLibrary) {
  for (const Lobe& lobe : lobes) {
    const PropertyCount one = reciprocity_with({.position = {-3, 2.5F, 7}}, lobe);
    EXPECT_EQ(one.cases, 1U);
    EXPECT_EQ(one.violations, 0U);
    Tally tally;
    Judge(0, 0, tally).lobe(lobe);
    EXPECT_EQ(tally[energy].cases, 5U);
    EXPECT_EQ(tally[energy].violations, 0U);
    EXPECT_GT(tally[energy].worst_ratio, 0.85);
  }
}

TEST(BrdfProperties, AskForReciprocityAboveTheHorizonOnly) {
  EXPECT_EQ(reciprocity_with({.position = {5, 2, 2.5F}}, lobes[1]).cases, 0U);
  EXPECT_EQ(reciprocity_with({.position = {1, 2, 3}}, lobes[1]).cases, 0U);
  EXPECT_EQ(reciprocity_with({.position = {5, 2, 5}}, lobes[1], {0.6F, 0, -0.8F}).cases, 0U);
  const Light sun{.kind = LightKind::directional, .position = {0, 0.6F, 0.8F}};
  EXPECT_EQ(reciprocity_with(sun, lobes[1]).cases, 1U);
}

// Its mirror direction is rounded: far more than evaluation loses, and allowed.
TEST(BrdfProperties, AllowPhongWhatTheMirrorDirectionLoses) {
  const Material mirror{glm::vec3(0), Phong{glm::vec3(1), Phong::max_exponent}};
  const auto unit = [](const glm::dvec3& v) { return glm::vec3(glm::normalize(v)); };
  const glm::vec3 n = unit({1, 2, 3}), v = unit({2, 1, 4});
  const ShadingFrame frame(glm::vec3(0), n, v);
  double most = 0;
  for (const double off : {-0.002, -0.001, 0.001, 0.002}) {
    const BothWays f = both_ways(mirror, n, unit(glm::dvec3(frame.mirror()) + off), v);
    EXPECT_LE(std::abs(f.there.x - f.back.x), f.allowed.x);
    most = std::max(most, std::abs(f.there.x - f.back.x) / f.there.x);
  }
  EXPECT_GT(most, 100 * transfer_error);
}

} // namespace
} // namespace lightcuts::oracle
