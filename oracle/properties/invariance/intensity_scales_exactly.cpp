// SPDX-License-Identifier: MIT
#include <algorithm>

#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

constexpr float brightening = 128;

bool brighten(Setting& s) {
  return std::all_of(s.lights.begin(), s.lights.end(),
                     [](Light& light) { return scale(light.intensity, brightening); });
}

} // namespace

const PropertyInfo property::intensity_scales_exactly{
    .name = "intensity-scales-exactly",
    .statement = "Lights 2^k times as bright: everything is, to the last bit.",
    .formula = "bounds, radiance at threshold 0 and certified error, divided by 2^k",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.exactly(brighten, brightening, record); },
};

} // namespace lightcuts::oracle
