// SPDX-License-Identifier: MIT
#include <oracle/properties/invariance/invariance.h>

namespace lightcuts::oracle {
namespace {

/// By 4, so that square roots of lengths scale exactly, too; intensities with it, so that what
/// arrives stays the same.
bool enlarge(Setting& s) {
  bool exact = scale(s.min_distance, 4) && scale(s.view.position, 4);
  for (Light& light : s.lights)
    if (!is_at_infinity(light.kind))
      exact = exact && scale(light.position, 4) && scale(light.intensity, 16);
  return exact;
}

} // namespace

const PropertyInfo property::length_scales_exactly{
    .name = "length-scales-exactly",
    .statement = "A scene 2^k times as large: nothing but 4^k changes.",
    .formula = "bounds and radiance at threshold 0, times 4^k, to the last bit",
    .promise = Promise::library,
    .of_invariance = [](const Invariance& of,
                        const Recorder& record) { of.exactly(enlarge, 1, record); },
};

} // namespace lightcuts::oracle
