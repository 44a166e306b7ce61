// SPDX-License-Identifier: MIT
#include <lightcuts/core/lights/profile_envelope.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <lightcuts/core/lights/profile_lookup.h>
#include <oracle/numbers/dice.h>
#include <oracle/truth/kinds.h>

namespace lightcuts {
namespace {

Profile random_profile(gen::Dice& dice) {
  Light light{.kind = LightKind::profile};
  oracle::radiometry::KindTruth<LightKind::profile>::finish(dice, light, {1, 2, 3});
  return light.profile;
}

double share_at(const Profile& profile, double cosine) {
  return detail::max_share(profile.table(), {}, cosine, cosine);
}

TEST(ProfileEnvelope, HasTheLargestShareOfAllHalfPlanes) {
  const Profile profile({.cosines = {1, -1},
                         .plane_cosines = {1, -0.6F, 0},
                         .plane_sines = {0, 0.8F, -1},
                         .shares = {1, 0, 0.5F, 0.75F, 0, 0.25F}});
  const ProfileTable expected{
      .cosines = {1, -1}, .plane_cosines = {1}, .plane_sines = {0}, .shares = {1, 0.75F}};
  EXPECT_EQ(envelope_of(profile).table(), expected);
  EXPECT_TRUE(envelope_of(envelope_of(profile)).is_same_object(envelope_of(envelope_of(profile))) ||
              envelope_of(envelope_of(profile)) == envelope_of(profile));
}

TEST(ProfileEnvelope, OfTwoIsNowhereBelowEitherAndNoMoreAtTheirRows) {
  gen::Dice dice(3);
  for (int i = 0; i < 2000; ++i) {
    const Profile a = envelope_of(random_profile(dice)), b = envelope_of(random_profile(dice));
    const Profile both = united(a, b);
    for (int k = 0; k < 40; ++k) {
      const double cosine = dice.uniform(-1, 1);
      ASSERT_GE(share_at(both, cosine) * (1 + 0x1p-40), share_at(a, cosine)) << i;
      ASSERT_GE(share_at(both, cosine) * (1 + 0x1p-40), share_at(b, cosine)) << i;
    }
    for (const float cosine : both.table().cosines) {
      const double most = std::max(share_at(a, cosine), share_at(b, cosine));
      ASSERT_LE(share_at(both, cosine), most * (1 + 0x1p-22) + 0x1p-149);
    }
  }
}

TEST(ProfileEnvelope, OfManyStaysSmallAndAboveThem) {
  gen::Dice dice(4);
  std::vector<Profile> all;
  Profile both;
  for (int i = 0; i < 60; ++i) {
    all.push_back(envelope_of(random_profile(dice)));
    both = i == 0 ? all[0] : united(both, all.back());
    ASSERT_LE(both.table().rows(), max_envelope_rows);
  }
  for (int k = 0; k < 4000; ++k) {
    const double cosine = dice.uniform(-1, 1);
    for (const Profile& one : all)
      ASSERT_GE(share_at(both, cosine) * (1 + 0x1p-40), share_at(one, cosine));
  }
}

TEST(ProfileEnvelope, OfOneAboveTheOtherIsThatOne) {
  const Profile low({.cosines = {1, -1}, .shares = {0.25F, 0.5F}});
  const Profile high({.cosines = {1, -1}, .shares = {0.75F, 0.5F}});
  EXPECT_TRUE(united(low, high).is_same_object(high));
  EXPECT_TRUE(united(high, low).is_same_object(high));
}

} // namespace
} // namespace lightcuts
