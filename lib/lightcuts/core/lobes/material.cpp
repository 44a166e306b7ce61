// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/material.h>

#include <string>

#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/number_text.h>

namespace lightcuts {
namespace {

constexpr float largest = 3.40282347e+38F;

void require(bool holds, const std::string& field, float value, const char* domain) {
  if (!holds)
    throw InputError(fault_of(value), field + " is " + number_text(value) + ", expected " + domain);
}

// Comparisons are written so that NaN fails, too.

void require_reflectance(const glm::vec3& value, const char* field) {
  for (int c = 0; c < 3; ++c)
    require(value[c] >= 0 && value[c] <= largest, std::string(field) + "." + "rgb"[c], value[c],
            "a finite number of 0 or more");
}

void require_alpha(float alpha) {
  require(alpha >= 0x1p-14F && alpha <= 1, "alpha", alpha, "2^-14 to 1");
}

} // namespace

void Phong::validate() const {
  require_reflectance(reflectance, "specular");
  require(exponent >= 0 && exponent <= max_exponent, "exponent", exponent, "0 to 2^20");
}

void Ward::validate() const {
  require_reflectance(reflectance, "specular");
  static_assert(min_alpha == 0x1p-14F);
  require_alpha(alpha);
}

void CookTorrance::validate() const {
  for (int c = 0; c < 3; ++c)
    require(f0[c] >= 0 && f0[c] <= 1, std::string("f0.") + "rgb"[c], f0[c], "0 to 1");
  static_assert(min_alpha == 0x1p-14F);
  require_alpha(alpha);
}

void validate(const Material& material) {
  require_reflectance(material.diffuse, "diffuse");
  std::visit([](const auto& lobe) { lobe.validate(); }, material.lobe);
}

Material diffuse_and_phong(const glm::vec3& diffuse, const glm::vec3& specular, float exponent) {
  Material material{diffuse, {}};
  if (specular != glm::vec3(0)) material.lobe = Phong{specular, exponent};
  return material;
}

} // namespace lightcuts
