// SPDX-License-Identifier: MIT
#include <lightcuts/light_set.h>

#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/generators.h"
#include <lightcuts/input_error.h>

namespace lightcuts {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// The message with which the third light is refused; empty if it is taken.
std::string refusal(const glm::vec3& position, const glm::vec3& intensity) {
  LightSet lights;
  lights.add_omni({0, 0, 0}, {1, 1, 1});
  lights.add_omni({0, 0, 0}, {1, 1, 1});
  try {
    lights.add_omni(position, intensity);
  } catch (const InputError& error) {
    EXPECT_EQ(lights.size(), 2U) << "a refused light must not stay";
    return error.what();
  }
  return {};
}

bool names(const std::string& message, const std::string& field) {
  return message.find("light 2") != std::string::npos && message.find(field) != std::string::npos &&
         message.find('\n') == std::string::npos;
}

TEST(LightSet, NamesTheLightAndTheFieldItRefuses) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float bad : {nan, inf, -inf}) {
      glm::vec3 v(1);
      v[axis] = bad;
      EXPECT_TRUE(names(refusal(v, {1, 1, 1}), std::string("position.") + "xyz"[axis]));
      EXPECT_TRUE(names(refusal({1, 1, 1}, v), std::string("intensity.") + "rgb"[axis]));
    }
  EXPECT_TRUE(names(refusal({0, 0, 0}, {1, -0x1p-149F, 1}), "intensity.g"));
}

TEST(LightSet, TakesBlackLightsAndNegativeZero) {
  EXPECT_EQ(refusal({0, 0, 0}, {0, 0, 0}), "");
  EXPECT_EQ(refusal({-0.0F, 0, 0}, {-0.0F, 0, 0}), "");
}

RC_GTEST_PROP(LightSet, KeepsWhatWasAddedInOrder, ()) {
  const gen::Scene scene = *gen::scene();
  const LightSet lights = scene.light_set();
  RC_ASSERT(lights.size() == scene.lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    RC_ASSERT(lights[i].position == scene.lights[i].position);
    RC_ASSERT(lights[i].intensity == scene.lights[i].intensity);
  }
}

TEST(LightSet, SaysHowNegativeAnIntensityIsHoweverLittle) {
  LightSet lights;
  try {
    lights.add_omni({0, 0, 0}, {1, -1e-9F, 0});
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "light 0: intensity.g is -1e-09, negative");
  }
}

} // namespace
} // namespace lightcuts
