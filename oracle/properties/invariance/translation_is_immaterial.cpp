// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

/// Adds, and says whether floats can express that exactly: what the sum has lost is 0 (Knuth 1969).
bool add(float& value, float by) {
  const float sum = value + by, seen = sum - value;
  const float lost = (value - (sum - seen)) + (by - seen);
  value = sum;
  return lost == 0;
}

bool shift(Setting& s) {
  const auto shifted = [](glm::vec3& v) {
    const bool x = add(v.x, 1), y = add(v.y, -2), z = add(v.z, 4);
    return x && y && z;
  };
  bool exact = shifted(s.view.position);
  for (Light& light : s.lights)
    if (!is_at_infinity(light.kind)) exact = shifted(light.position) && exact;
  return exact;
}

} // namespace

const PropertyInfo property::translation_is_immaterial{
    .name = "translation-is-immaterial",
    .statement = "A shift of the whole scene changes nothing.",
    .formula = "radiance at threshold 0 and the root's bound, but for rounding",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.closely(shift, record); },
};

} // namespace lightcuts::oracle
