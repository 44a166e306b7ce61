// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

bool turn(Setting& s) {
  const auto turned = [](glm::vec3& v) { v = {v.y, v.z, v.x}; };
  turned(s.view.position);
  turned(s.view.normal);
  turned(s.view.to_viewer);
  for (Light& light : s.lights) {
    turned(light.position);
    turned(light.axis);
    turned(light.plane);
  }
  return true;
}

} // namespace

const PropertyInfo property::rotation_is_immaterial{
    .name = "rotation-is-immaterial",
    .statement = "A turn of the whole scene by right angles changes nothing.",
    .formula = "radiance at threshold 0 and the root's bound, but for rounding",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of, const Recorder& record) { of.closely(turn, record); },
};

} // namespace lightcuts::oracle
