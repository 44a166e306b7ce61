// SPDX-License-Identifier: MIT
#include <lightcuts/material.h>

#include <string>

#include "number_text.h"
#include <lightcuts/input_error.h>

namespace lightcuts {
namespace {

constexpr float largest = 3.40282347e+38F;

void require(bool holds, const std::string& field, float value, const char* domain) {
  if (!holds) throw InputError(field + " is " + number_text(value) + ", expected " + domain);
}

} // namespace

void validate(const Material& material) {
  for (int c = 0; c < 3; ++c) {
    const std::string channel = std::string(".") + "rgb"[c];
    // Written so that NaN fails too.
    require(material.diffuse[c] >= 0 && material.diffuse[c] <= largest, "diffuse" + channel,
            material.diffuse[c], "a finite number of 0 or more");
    require(material.specular[c] >= 0 && material.specular[c] <= largest, "specular" + channel,
            material.specular[c], "a finite number of 0 or more");
  }
  require(material.exponent >= 0 && material.exponent <= Material::max_exponent, "exponent",
          material.exponent, "0 to 2^20");
}

} // namespace lightcuts
