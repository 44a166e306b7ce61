// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

bool add_black(Setting& s) {
  s.lights.push_back(s.lights[s.lights.size() / 2]);
  s.lights.back().intensity = glm::vec3(0);
  return true;
}

} // namespace

const PropertyInfo property::black_light_is_immaterial{
    .name = "black-light-is-immaterial",
    .statement = "A light of intensity 0 changes nothing.",
    .formula = "radiance at threshold 0 and the root's bound, but for rounding",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.closely(add_black, record); },
};

} // namespace lightcuts::oracle
