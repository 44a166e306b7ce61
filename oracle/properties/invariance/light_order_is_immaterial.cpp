// SPDX-License-Identifier: MIT
#include <algorithm>

#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

bool reverse(Setting& s) {
  std::reverse(s.lights.begin(), s.lights.end());
  return s.lights.size() > 1;
}

} // namespace

const PropertyInfo property::light_order_is_immaterial{
    .name = "light-order-is-immaterial",
    .statement = "The order of the lights changes nothing.",
    .formula = "radiance at threshold 0 and the root's bound, but for rounding",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.closely(reverse, record); },
};

} // namespace lightcuts::oracle
