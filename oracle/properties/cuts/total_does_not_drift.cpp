// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

void check_drift(const CutAnswer& of, const Recorder& record) {
  const Wide& total = of.total;
  const glm::vec3& radiance = of.cut.radiance;
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (radiance[c] == std::numeric_limits<float>::infinity()) { // saturated
      holds = holds && total[c] > std::numeric_limits<float>::max() * (1 - of.sum_error());
      continue;
    }
    const long double allowed = total[c] * (0x1p-24L + of.sum_error()) + 0x1p-150L;
    const long double drift = std::abs(radiance[c] - total[c]);
    holds = holds && drift <= allowed;
    worst = std::max(worst, ratio_of(drift, allowed));
  }
  record(holds, worst, [&] {
    return fmt::format("{}: radiance {}, estimates sum to {}", of.point.at.text(),
                       digits_of(radiance), digits_of({total[0], total[1], total[2]}));
  });
}

} // namespace

const PropertyInfo property::total_does_not_drift{
    .name = "total-does-not-drift",
    .statement = "The radiance is the sum of the estimates over the cut.",
    .formula = "|radiance - sum of estimates| <= rounding of that sum, per channel",
    .needs = only(Part::cuts),
    .of_cut = check_drift,
};

} // namespace lightcuts::oracle
