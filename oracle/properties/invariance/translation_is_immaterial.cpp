// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

bool shift(Setting& s) {
  constexpr glm::vec3 by(1, -2, 4);
  const auto shifted = [&](glm::vec3& v) {
    const glm::vec3 moved = v + by;
    const bool exact = glm::dvec3(moved) == glm::dvec3(v) + glm::dvec3(by) && moved - by == v;
    v = moved;
    return exact;
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
