// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/profile.h>

#include <functional>
#include <limits>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/lights/light_set.h>

namespace lightcuts {
namespace {

ProfileTable three_planes() {
  return {.cosines = {1, 0, -1},
          .plane_cosines = {1, -0.6F, 0},
          .plane_sines = {0, 0.8F, -1},
          .shares = {1, 1, 1, 0.5F, 0.5F, 0.5F, 0, 0, 0}};
}

void expect_refused(InputFault fault, const std::function<void(ProfileTable&)>& spoil,
                    const std::string& part) {
  ProfileTable table = three_planes();
  spoil(table);
  try {
    const Profile profile(table);
    ADD_FAILURE() << part;
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault(), fault) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Profile, KeepsAValidTable) {
  EXPECT_EQ(Profile(three_planes()).table(), three_planes());
  EXPECT_EQ(Profile().table(), ProfileTable());
  EXPECT_TRUE(Profile().table().is_round());
}

TEST(Profile, IsEqualByItsTable) {
  const Profile a(three_planes()), copy = a, b(three_planes());
  EXPECT_TRUE(copy.is_same_object(a));
  EXPECT_FALSE(b.is_same_object(a));
  EXPECT_EQ(a, b);
  EXPECT_FALSE(a == Profile());
  EXPECT_EQ(Profile(ProfileTable()), Profile());
}

TEST(Profile, RefusesWhatIsNoTable) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  using T = ProfileTable;
  expect_refused(
      InputFault::not_finite, [&](T& t) { t.shares[3] = nan; }, "shares 3 is nan");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.shares[8] = 1.5F; }, "shares 8");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.shares[8] = -1; }, "shares 8");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.cosines[0] = 1.5F; }, "cosines 0");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.cosines[1] = 1; }, "cosines 1");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.cosines[0] = 0.5F; }, "0.5, expected 1");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.cosines[2] = -0.5F; }, "expected -1");
  expect_refused(
      InputFault::inconsistent, [](T& t) { t.cosines = {1}; }, "less than two");
  expect_refused(
      InputFault::inconsistent, [](T& t) { t.shares.pop_back(); }, "a share for each");
  expect_refused(
      InputFault::inconsistent, [](T& t) { t.plane_sines.pop_back(); }, "plane_sines");
  expect_refused(
      InputFault::inconsistent, [](T& t) { t.plane_sines = t.plane_cosines = {}; }, "at least one");
  expect_refused(
      InputFault::out_of_domain, [](T& t) { t.plane_cosines[1] = -0.5F; }, "not unit");
}

TEST(Profile, RefusesHalfPlanesThatDoNotGoRound) {
  using T = ProfileTable;
  const auto with = [](std::vector<float> cosines, std::vector<float> sines) {
    return [=](T& t) {
      t.shares = std::vector<float>(3 * cosines.size(), 1);
      t.plane_cosines = cosines;
      t.plane_sines = sines;
    };
  };
  const auto refused = InputFault::out_of_domain;
  expect_refused(refused, with({1, 0}, {0, 1}), "less than pi");
  expect_refused(refused, with({1, 0, -1}, {0, 1, 0}), "less than pi");
  expect_refused(refused, with({1, 0, -0.6F}, {0, -1, 0.8F}), "less than pi");
  expect_refused(refused, with({1, 1, -0.6F, 0}, {0, 0, 0.8F, -1}), "less than pi");
  // Twice around.
  expect_refused(refused, with({1, 0, -1, 0, 0.6F, 0, -1, 0}, {0, 1, 0, -1, 0.8F, 1, 0, -1}),
                 "increasing");
}

TEST(Profile, IsOfNoUseToLightsOfOtherKinds) {
  LightSet lights;
  lights.add_profile({0, 1, 0}, {0, -1, 0}, {1, 0, 0}, glm::vec3(2), Profile(three_planes()));
  EXPECT_EQ(lights[0].profile.table(), three_planes());
  EXPECT_EQ(lights.kinds(), only(LightKind::profile));
  EXPECT_THROW(lights.add_profile({0, 1, 0}, {0, -1, 0}, {1, 1, 0}, glm::vec3(2), {}), InputError);
  EXPECT_THROW(lights.add_profile({0, 1, 0}, {0, -2, 0}, {1, 0, 0}, glm::vec3(2), {}), InputError);
  EXPECT_EQ(lights.size(), 1U);
}

} // namespace
} // namespace lightcuts
