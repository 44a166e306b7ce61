// SPDX-License-Identifier: MIT
#include <lightcuts/material.h>

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <lightcuts/input_error.h>

namespace lightcuts {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

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
      Material diffuse, specular;
      diffuse.diffuse[c] = bad;
      specular.specular[c] = bad;
      EXPECT_TRUE(names(refusal(diffuse), std::string("diffuse.") + "rgb"[c]));
      EXPECT_TRUE(names(refusal(specular), std::string("specular.") + "rgb"[c]));
    }
  for (const float bad : {nan, inf, -0x1p-149F, 0x1.000002p20F})
    EXPECT_TRUE(names(refusal({glm::vec3(0), glm::vec3(0), bad}), "exponent"));
}

TEST(Material, TakesTheEndsOfItsDomain) {
  const glm::vec3 largest(std::numeric_limits<float>::max());
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({largest, largest, Material::max_exponent}), "");
}

TEST(Material, HasSpecularIfAnyChannelHas) {
  EXPECT_FALSE((Material{glm::vec3(1)}).has_specular());
  EXPECT_TRUE((Material{glm::vec3(0), {0, 0, 0x1p-149F}}).has_specular());
}

} // namespace
} // namespace lightcuts
