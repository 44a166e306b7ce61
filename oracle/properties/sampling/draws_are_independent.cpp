// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/sampling/draws.h>

namespace lightcuts::oracle {
namespace {

/// Of each two successive queries.
void check_successive(const Draws& of, const Recorder& record) {
  const std::size_t channel = of.brightest_channel();
  const Spread& spread = of.spread(channel);
  const std::uint64_t pairs = of.count() / 2;
  if (pairs == 0) return;
  const double truth = double(of.point.at.truth.seen(0)[channel]);
  const double allowed =
      bernstein_deviation({spread.variance * spread.variance, spread.range * spread.range}, pairs,
                          of.rate()) +
      (spread.variance + truth * truth) * 0x1p-21; // radiance is a float
  const auto off =
      static_cast<double>(std::abs(of.sums().successive / static_cast<long double>(pairs)));
  record(off <= allowed, ratio_of(off, allowed), [&] {
    return fmt::format("{}: radiances of each two successive queries have a covariance of {:.6g}; "
                       "of independent ones {} would show at most {:.6g}",
                       of.point.at.text(), off, pairs, allowed);
  });
}

void check_independence(const Draws& of, const Recorder& record) {
  const DrawSums& sums = of.sums();
  record(sums.same_cut,
         [&] { return fmt::format("{}: the cut depends on what is drawn", of.point.at.text()); });
  if (!sums.same_cut) return;
  const std::size_t channel = of.brightest_channel();
  const double truth = double(of.point.at.truth.seen(0)[channel]);
  check_successive(of, record);
  for (std::size_t k = 0; k < of.pairs().size(); ++k) {
    const RandomCluster& one = of.clusters()[of.pairs()[k].first];
    const RandomCluster& other = of.clusters()[of.pairs()[k].second];
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
    .statement = "What is drawn of one cluster says nothing of another, nor a query of the next.",
    .formula = "|mean of (e - mean e) (e' - mean e')| <= Bernstein's deviation, for pairs of "
               "clusters, and of successive queries",
    .needs = only(Part::sampling) | only(Part::random_cuts),
    .of_draws = check_independence,
};

} // namespace lightcuts::oracle
