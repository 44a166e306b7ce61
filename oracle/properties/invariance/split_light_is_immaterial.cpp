// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

bool split(Setting& s) {
  Light quarter = s.lights.front();
  for (int c = 0; c < 3; ++c)
    if (quarter.intensity[c] != 0 && quarter.intensity[c] < 0x1p-100F) return false;
  quarter.intensity *= 0.25F;
  s.lights.front() = quarter;
  s.lights.insert(s.lights.end(), 3, quarter);
  return true;
}

} // namespace

const PropertyInfo property::split_light_is_immaterial{
    .name = "split-light-is-immaterial",
    .statement = "Four quarters of a light are that light.",
    .formula = "radiance at threshold 0 and the root's bound, but for rounding",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.closely(split, record); },
};

} // namespace lightcuts::oracle
