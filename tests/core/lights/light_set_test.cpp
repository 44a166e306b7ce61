// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/light_set.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/input_error.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using std::numbers::pi;

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

bool names_third_light(const std::string& message, const std::string& field) {
  return message.find("light 2") != std::string::npos && message.find(field) != std::string::npos &&
         message.find('\n') == std::string::npos;
}

TEST(LightSet, NamesTheLightAndTheFieldItRefuses) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float bad : {nan, inf, -inf}) {
      glm::vec3 v(1);
      v[axis] = bad;
      EXPECT_TRUE(names_third_light(refusal(v, {1, 1, 1}), std::string("position.") + "xyz"[axis]));
      EXPECT_TRUE(
          names_third_light(refusal({1, 1, 1}, v), std::string("intensity.") + "rgb"[axis]));
    }
  EXPECT_TRUE(names_third_light(refusal({0, 0, 0}, {1, -0x1p-149F, 1}), "intensity.g"));
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
    RC_ASSERT(lights[i].kind == scene.lights[i].kind);
    RC_ASSERT((lights.kinds() & only(lights[i].kind)) != 0);
  }
}

/// The message with which a set of one light refuses what `add` adds; empty if it takes it.
template <class Add>
std::string refusal_of(Add&& add) {
  LightSet lights;
  lights.add_omni({0, 0, 0}, {1, 1, 1});
  try {
    add(lights);
  } catch (const InputError& error) {
    EXPECT_EQ(lights.size(), 1U) << "a refused light must not stay";
    return error.what();
  }
  return {};
}

TEST(LightSet, RefusesDirectionsThatAreNotUnit) {
  const glm::vec3 one(1);
  for (const glm::vec3& bad : {glm::vec3(0), glm::vec3(0, 0.999F, 0), glm::vec3(1e30F)}) {
    EXPECT_THAT(refusal_of([&](LightSet& l) { l.add_oriented({}, bad, one); }),
                testing::StartsWith("light 1: normal has length"));
    EXPECT_THAT(refusal_of([&](LightSet& l) { l.add_spot({}, bad, one, 0, 1); }),
                testing::StartsWith("light 1: axis has length"));
    EXPECT_THAT(refusal_of([&](LightSet& l) { l.add_directional(bad, one); }),
                testing::StartsWith("light 1: direction has length"));
  }
  EXPECT_THAT(refusal_of([&](LightSet& l) {
                l.add_oriented({}, {0, nan, 0}, one);
              }),
              testing::HasSubstr("normal.y is nan"));
}

TEST(LightSet, RefusesConesThatAreNone) {
  const auto refused = [](float inner, float outer) {
    return refusal_of([&](LightSet& l) { l.add_spot({}, {0, 0, 1}, {1, 1, 1}, inner, outer); });
  };
  for (const float bad : {0.0F, -0.1F, 3.1416F, nan, inf})
    EXPECT_THAT(refused(0, bad), testing::HasSubstr("light 1: outer angle is"));
  for (const float bad : {-0.1F, 1.0F, 1.1F, nan})
    EXPECT_THAT(refused(bad, 1), testing::HasSubstr("light 1: inner angle is"));
  EXPECT_EQ(refused(0, 3.1415927F), "");
}

TEST(LightSet, WidensARimOutwardsThatFloatsCannotTell) {
  LightSet lights;
  lights.add_spot({}, {0, 0, 1}, {1, 1, 1}, 0.5F, std::nextafter(0.5F, 1.0F));
  EXPECT_EQ(lights[0].cos_inner, float(std::cos(0.5)));
  EXPECT_EQ(lights[0].cos_outer, std::nextafter(lights[0].cos_inner, 0.0F));
  lights.add_spot({}, {0, 0, 1}, {1, 1, 1}, 0, 1e-6F);
  EXPECT_EQ(lights[1].cos_inner, 1);
  EXPECT_EQ(lights[1].cos_outer, 1 - 0x1p-24F);
}

// A cosine near 1 is known to half a step of 2^-24: a cone of 0.5 degrees to 0.04 % of the angle.
TEST(LightSet, KeepsNarrowCones) {
  for (const auto& [inner, outer] : {std::pair{0.0, 0.5}, {1.0, 2.0}, {0.4, 0.5}, {29.99, 30.0}}) {
    LightSet lights;
    lights.add_spot({}, {0, 0, 1}, {1, 1, 1}, float(inner * pi / 180), float(outer * pi / 180));
    const auto expect_angle = [](float cosine, double degrees) {
      const double angle = degrees * pi / 180;
      const double error = 0x1p-25 / std::max(std::sin(angle), 0x1p-12) + 0x1p-24;
      EXPECT_NEAR(std::acos(double(cosine)), angle, 1.01 * error) << degrees;
    };
    expect_angle(lights[0].cos_inner, inner);
    expect_angle(lights[0].cos_outer, outer);
  }
}

TEST(LightSet, KeepsTheDirectionTowardsADirectionalLight) {
  LightSet lights;
  lights.add_directional({0, -1, 0}, {1, 2, 3});
  EXPECT_EQ(lights[0].position, glm::vec3(0, 1, 0));
  EXPECT_EQ(lights[0].intensity, glm::vec3(1, 2, 3));
}

// ---- lights as they are

/// A valid light of the kind, of which every field counts that the kind has.
Light valid_light(LightKind kind) {
  return {.kind = kind,
          .position = {0, 1, 0},
          .intensity = {1, 2, 3},
          .axis = {0, 0, 1},
          .cos_inner = 0.5F,
          .cos_outer = 0.25F,
          .plane = {0, 1, 0}};
}

/// What is refused of a light that is valid but for what `alter` does to it.
template <class Alter>
std::string refusal_of_altered(LightKind kind, Alter&& alter) {
  Light light = valid_light(kind);
  alter(light);
  return refusal_of([&](LightSet& l) { l.add(light); });
}

class LightsAsTheyAre : public testing::TestWithParam<LightKind> {};
INSTANTIATE_TEST_SUITE_P(EveryKind, LightsAsTheyAre,
                         testing::Values(LightKind::omni, LightKind::oriented, LightKind::spot,
                                         LightKind::directional, LightKind::profile),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST_P(LightsAsTheyAre, AreTakenWhereAllFieldsAreInTheirDomains) {
  EXPECT_EQ(refusal_of_altered(GetParam(), [](Light&) {}), "");
  EXPECT_EQ(refusal_of_altered(GetParam(), [](Light& l) { l.intensity = glm::vec3(-0.0F); }), "");
}

TEST_P(LightsAsTheyAre, AreRefusedByTheNameOfTheFieldThatIsNotFinite) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float bad : {nan, -nan, inf, -inf}) {
      EXPECT_THAT(refusal_of_altered(GetParam(), [&](Light& l) { l.position[axis] = bad; }),
                  testing::StartsWith(std::string("light 1: position.") + "xyz"[axis] + " is "));
      EXPECT_THAT(refusal_of_altered(GetParam(), [&](Light& l) { l.intensity[axis] = bad; }),
                  testing::StartsWith(std::string("light 1: intensity.") + "rgb"[axis] + " is "));
      const std::string axis_refusal =
          refusal_of_altered(GetParam(), [&](Light& l) { l.axis[axis] = bad; });
      if (has_axis(GetParam())) {
        EXPECT_THAT(axis_refusal,
                    testing::StartsWith(std::string("light 1: axis.") + "xyz"[axis] + " is "));
      } else {
        EXPECT_EQ(axis_refusal, "") << "of such lights nobody reads it";
      }
    }
}

TEST_P(LightsAsTheyAre, AreRefusedWhereIntensitiesAreNegative) {
  EXPECT_EQ(refusal_of_altered(GetParam(), [](Light& l) { l.intensity.y = -0x1p-149F; }),
            "light 1: intensity.g is -1e-45, negative");
}

TEST_P(LightsAsTheyAre, AreRefusedWhereDirectionsAreNotUnit) {
  for (const glm::vec3& bad : {glm::vec3(0), glm::vec3(0, 0.999F, 0), glm::vec3(1e30F)}) {
    const auto refused = [&](glm::vec3 Light::*field) {
      return refusal_of_altered(GetParam(), [&](Light& l) { l.*field = bad; });
    };
    EXPECT_EQ(
        testing::Value(refused(&Light::axis), testing::StartsWith("light 1: axis has length")),
        has_axis(GetParam()));
    EXPECT_EQ(testing::Value(refused(&Light::position),
                             testing::StartsWith("light 1: position has length")),
              is_at_infinity(GetParam()));
    EXPECT_EQ(
        testing::Value(refused(&Light::plane), testing::StartsWith("light 1: plane has length")),
        GetParam() == LightKind::profile);
  }
}

TEST(LightSet, RefusesRimsThatAreNone) {
  const auto refused = [](float inner, float outer) {
    return refusal_of_altered(LightKind::spot, [&](Light& l) {
      l.cos_inner = inner;
      l.cos_outer = outer;
    });
  };
  for (const float bad : {nan, inf, -inf, 1.0001F, -1.0001F})
    EXPECT_THAT(refused(bad, -1), testing::StartsWith("light 1: cos_inner is"));
  for (const float bad : {nan, inf, -inf, 1.0001F, -1.001F})
    EXPECT_THAT(refused(1, bad), testing::StartsWith("light 1: cos_outer is"));
  for (const float bad : {0.5F, 0.6F})
    EXPECT_EQ(refused(0.5F, bad), "light 1: cos_inner is 0.5, expected more than cos_outer");
  EXPECT_EQ(refused(0.5F, std::nextafter(0.5F, 0.0F)), "");
}

TEST(LightSet, RefusesAKindThatThereIsNot) {
  EXPECT_EQ(refusal_of_altered(LightKind(5), [](Light&) {}), "light 1: kind is 5, not one of 5");
}

TEST(LightSet, SaysWhyALightAsItIsIsRefused) {
  const auto fault = [](const Light& light) {
    try {
      LightSet().add(light);
    } catch (const InputError& e) {
      return e.fault();
    }
    return InputFault::missing;
  };
  Light light = valid_light(LightKind::spot);
  light.cos_outer = nan;
  EXPECT_EQ(fault(light), InputFault::not_finite);
  light.cos_outer = -2;
  EXPECT_EQ(fault(light), InputFault::out_of_domain);
  light.cos_outer = light.cos_inner;
  EXPECT_EQ(fault(light), InputFault::out_of_domain);
  light.axis = glm::vec3(0);
  EXPECT_EQ(fault(light), InputFault::not_unit);
  light.intensity.x = -1;
  EXPECT_EQ(fault(light), InputFault::negative);
}

// Of a set that took them once: the narrow rim at the back reaches beyond -1.
TEST(LightSet, TakesAllLightsOfAnotherSet) {
  LightSet lights;
  lights.add_spot({}, {0, 0, 1}, {1, 1, 1}, 3.1415925F, 3.1415927F);
  lights.add_spot({}, {0, 0, 1}, {1, 1, 1}, 0, 1e-6F);
  lights.add_directional({0, -1.000009F, 0}, {1, 2, 3});
  lights.add_oriented({1, 2, 3}, {0.999991F, 0, 0}, {0, 0, 0});
  LightSet again;
  for (const Light& light : lights) again.add(light);
  for (std::size_t i = 0; i < lights.size(); ++i) EXPECT_EQ(again[i], lights[i]);
  EXPECT_EQ(again.kinds(), lights.kinds());
  EXPECT_LT(again[0].cos_outer, -1);
}

TEST(LightSet, RefusesAClampThatIsNone) {
  for (const float bad : {0.0F, -1.0F, nan, inf})
    EXPECT_THAT(refusal_of([&](LightSet& l) { l.set_min_distance(bad); }),
                testing::StartsWith("min_distance is"));
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
