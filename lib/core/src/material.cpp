// SPDX-License-Identifier: MIT
#include <lightcuts/material.h>

#include <string>

#include <lightcuts/input_error.h>

namespace lightcuts {
namespace {

constexpr float largest = 3.40282347e+38F;

void require(bool holds, const std::string& field, float value) {
  if (!holds) throw InputError(field + " is " + std::to_string(value) + ", out of its domain");
}

} // namespace

void validate(const Material& material) {
  for (int c = 0; c < 3; ++c) {
    const std::string channel = std::string(".") + "rgb"[c];
    // Written so that NaN fails too.
    require(material.diffuse[c] >= 0 && material.diffuse[c] <= largest, "diffuse" + channel,
            material.diffuse[c]);
    require(material.specular[c] >= 0 && material.specular[c] <= largest, "specular" + channel,
            material.specular[c]);
  }
  require(material.exponent >= 0 && material.exponent <= Material::max_exponent, "exponent",
          material.exponent);
}

} // namespace lightcuts
