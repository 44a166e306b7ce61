// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/material.h>

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <lightcuts/core/input_error.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

std::string refusal(const Material& material) {
  try {
    validate(material);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool names(const std::string& message, const std::string& field) {
  return message.find(field) != std::string::npos;
}

TEST(Material, NamesTheFieldItRefuses) {
  for (int c = 0; c < 3; ++c)
    for (const float bad : {nan, inf, -inf, -0x1p-149F}) {
      Material diffuse;
      diffuse.diffuse[c] = bad;
      glm::vec3 colour(0);
      colour[c] = bad;
      EXPECT_TRUE(names(refusal(diffuse), std::string("diffuse.") + "rgb"[c]));
      EXPECT_TRUE(names(refusal({{}, Phong{colour, 1}}), std::string("specular.") + "rgb"[c]));
      EXPECT_TRUE(names(refusal({{}, Ward{colour, 1}}), std::string("specular.") + "rgb"[c]));
      EXPECT_TRUE(names(refusal({{}, CookTorrance{colour, 1}}), std::string("f0.") + "rgb"[c]));
    }
  EXPECT_TRUE(names(refusal({{}, CookTorrance{{0, 1.0000001F, 0}, 1}}), "f0.g"));
  for (const float bad : {nan, inf, -0x1p-149F, 0x1.000002p20F})
    EXPECT_TRUE(names(refusal({{}, Phong{{}, bad}}), "exponent"));
  for (const float bad : {nan, inf, -1.0F, 0.0F, 0x1.fffffep-15F, 0x1.000002p0F}) {
    EXPECT_TRUE(names(refusal({{}, Ward{{}, bad}}), "alpha"));
    EXPECT_TRUE(names(refusal({{}, CookTorrance{{}, bad}}), "alpha"));
  }
}

TEST(Material, TakesTheEndsOfItsDomain) {
  const glm::vec3 largest(std::numeric_limits<float>::max());
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({largest, Phong{largest, Phong::max_exponent}}), "");
  EXPECT_EQ(refusal({largest, Ward{largest, Ward::min_alpha}}), "");
  EXPECT_EQ(refusal({largest, CookTorrance{glm::vec3(1), CookTorrance::min_alpha}}), "");
}

TEST(Material, OfPhongIsGlossyIfAnyChannelIs) {
  EXPECT_FALSE(diffuse_and_phong(glm::vec3(1), glm::vec3(0), 10).is_glossy());
  EXPECT_TRUE(diffuse_and_phong(glm::vec3(1), {0, 0, 0x1p-149F}, 10).is_glossy());
}

} // namespace
} // namespace lightcuts
