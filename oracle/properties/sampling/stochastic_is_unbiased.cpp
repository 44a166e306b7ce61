// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/sampling/draws.h>

namespace lightcuts::oracle {
namespace {

void check_mean(const Draws& of, const Recorder& record) {
  if (!of.sums().same_cut) return;
  for (std::size_t c = 0; c < 3; ++c) {
    const long double exact = of.point.at.truth.seen(0)[c];
    const long double mean = of.sums().radiance[c] / static_cast<long double>(of.count());
    // Each radiance is a float.
    const double allowed = bernstein_deviation(of.spread(c), of.count(), of.rate()) +
                           double(exact) * 0x1p-23 + 0x1p-149;
    const auto off = static_cast<double>(std::abs(mean - exact));
    record(off <= allowed, ratio_of(off, allowed), [&] {
      return fmt::format("{}: mean of {} draws {:.9g}, exact {:.9g}, channel {}",
                         of.point.at.text(), of.count(), double(mean), double(exact), "rgb"[c]);
    });
  }
}

} // namespace

const PropertyInfo property::stochastic_is_unbiased{
    .name = "stochastic-is-unbiased",
    .statement = "In the mean, draws give the exact sum.",
    .formula = "|mean of radiance - exact| <= Bernstein's deviation, per channel",
    .needs = only(Part::sampling) | only(Part::random_cuts),
    .of_draws = check_mean,
};

} // namespace lightcuts::oracle
