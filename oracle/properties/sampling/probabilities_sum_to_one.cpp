// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/sampling/cluster_odds.h>

namespace lightcuts::oracle {
namespace {

void check_sum(const ClusterOdds& of, const Recorder& record) {
  long double sum = 0;
  bool all_shine = true;
  for (std::size_t i = 0; i < of.p.size(); ++i) {
    sum += of.p[i];
    all_shine = all_shine && of.shines(i);
  }
  // Each level multiplies numbers that round by 2^-52 at most.
  const long double rounding = 0x1p-50L * static_cast<long double>(of.p.size());
  const long double off = all_shine ? std::abs(sum - 1) : std::max(sum - 1, 0.0L);
  record(off <= rounding, ratio_of(off, rounding), [&] {
    return fmt::format("{}: the probabilities in node {} sum to {}", of.point.at.text(), of.node,
                       double(sum));
  });
}

} // namespace

const PropertyInfo property::probabilities_sum_to_one{
    .name = "probabilities-sum-to-one",
    .statement = "The lights of a cluster are drawn with probabilities that sum to 1, or less "
                 "where none may be drawn.",
    .formula = "sum <= 1 + rounding; >= 1 - rounding where each light contributes",
    .needs = only(Part::sampling),
    .of_odds = check_sum,
};

} // namespace lightcuts::oracle
