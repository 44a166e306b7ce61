// SPDX-License-Identifier: MIT
#include <cmath>

#include <oracle/properties/both_sides.h>
#include <oracle/properties/bounds/worst_channel.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

void check_error(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  const glm::vec3& bound = of.bounds()[node];
  const glm::dvec3& estimate = of.estimates()[node];
  WorstChannel worst;
  for (int c = 0; c < 3; ++c) {
    const long double truth = of.at.truth.seen(node)[c];
    const long double error = std::abs(estimate[c] - truth);
    // The subtraction rounds, too.
    const long double margin = truth * truth_error + error * truth_error;
    worst.add(c,
              dominates(bound[c], error, margin,
                        [&] { return abs(Exact(estimate[c]) - of.at.truth.exact_seen(node, c)); }),
              error, bound[c]);
  }
  record(worst.holds, worst.ratio,
         [&] { return sides_text(of, node, worst, "true error", "bound", bound[worst.channel]); });
}

BothSides error_sides(const PointAnswers& of, std::uint32_t node) {
  BothSides sides = bound_sides(of, node);
  sides.left_name = "error of the estimate";
  const glm::dvec3& estimate = of.estimates()[node];
  const Truth& truth = of.at.truth;
  for (int c = 0; c < 3; ++c)
    sides.left[std::size_t(c)] = abs(exact_of(estimate[c]) - truth.exact_seen(node, c));
  sides.rows = row_of("of that, seen",
                      [&](int c) { return oracle::text_of(truth.exact_seen(node, c), 20); }) +
               number_row("estimate", estimate);
  return sides;
}

} // namespace

const PropertyInfo property::bound_dominates_error{
    .name = "bound-dominates-error",
    .statement = "A cluster's bound is at least the error of its estimate, whatever is occluded.",
    .formula = "|estimate - sum of seen contributions| <= bound, per channel",
    .needs = only(Part::bounds) | only(Part::estimates),
    .of_clusters = each_cluster<check_error>,
    .sides = error_sides,
};

} // namespace lightcuts::oracle
