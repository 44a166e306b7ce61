// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/sampling/draws.h>

namespace lightcuts::oracle {
namespace {

void check_independence(const Draws& of, const Recorder& record) {
  const DrawSums& sums = of.sums();
  record(sums.same_cut,
         [&] { return fmt::format("{}: the cut depends on what is drawn", of.point.at.text()); });
  if (!sums.same_cut) return;
  const std::size_t channel = of.brightest_channel();
  const double truth = double(of.point.at.truth.seen(0)[channel]);
  for (std::size_t k = 0; k + 1 < of.clusters().size(); ++k) {
    const RandomCluster &one = of.clusters()[k], &other = of.clusters()[k + 1];
    const Spread &a = one.spread[channel], &b = other.spread[channel];
    const double allowed =
        bernstein_deviation({a.variance * b.variance, a.range * b.range}, of.count(), of.rate()) +
        truth * truth * 0x1p-40;
    const auto n = static_cast<long double>(of.count());
    const auto off = static_cast<double>(std::abs(sums.products[k] / n));
    record(off <= allowed, ratio_of(off, allowed), [&] {
      return fmt::format("{}: draws of nodes {} and {} have a covariance of {:.6g}; of independent "
                         "ones {} would show at most {:.6g}",
                         of.point.at.text(), one.node, other.node, off, of.count(), allowed);
    });
  }
}

} // namespace

const PropertyInfo property::draws_are_independent{
    .name = "draws-are-independent",
    .statement = "What is drawn of one cluster says nothing of another.",
    .formula = "|mean of (e - mean e) (e' - mean e')| <= Bernstein's deviation, for pairs of "
               "clusters",
    .needs = only(Part::sampling) | only(Part::random_cuts),
    .of_draws = check_independence,
};

} // namespace lightcuts::oracle
