// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

TwoCuts seen_and_open(const PointAnswers& of, const CutConfig&) {
  const CutConfig exact = exact_cut(of.at.lights().size());
  return {{exact, true}, {exact, false}};
}

void check_darkening(const PointAnswers& of, const CutConfig&, const Recorder& record) {
  const CutConfig exact = exact_cut(of.at.lights().size());
  const glm::vec3 all = of.select(exact, true).radiance;
  const glm::vec3 seen = of.select(exact).radiance;
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (all[c] == std::numeric_limits<float>::infinity()) continue;
    // Both sums round.
    const double allowed = double(all[c]) + 2 * double(certified_error(all[c], 0));
    holds = holds && seen[c] <= allowed;
    worst = std::max(worst, ratio_of(seen[c], allowed));
  }
  record(holds, worst, [&] {
    return fmt::format("{}: radiance {}, with all lights seen {}", of.at.text(), digits_of(seen),
                       digits_of(all));
  });
}

} // namespace

const PropertyInfo property::visibility_only_darkens{
    .name = "visibility-only-darkens",
    .statement = "Occluding lights does not add light.",
    .formula = "radiance at threshold 0 <= the same with all lights seen, but for rounding, per "
               "channel",
    .needs = only(Part::cuts),
    .of_point = check_darkening,
    .two_cuts = seen_and_open,
};

} // namespace lightcuts::oracle
