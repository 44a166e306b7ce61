// SPDX-License-Identifier: MIT
#include <oracle/properties/both_sides.h>
#include <oracle/properties/bounds/worst_channel.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

void check_order(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  const glm::vec3 low = of.judged.tree.lower_bound(node, of.at.point);
  const glm::vec3& bound = of.bounds()[node];
  WorstChannel worst;
  for (int c = 0; c < 3; ++c) {
    const long double truth = of.at.truth.open(node)[c];
    const long double margin = truth * truth_error;
    bool holds = low[c] <= bound[c] && low[c] <= truth + margin;
    if (holds && low[c] > truth - margin) holds = Exact(low[c]) <= of.at.truth.exact_open(node, c);
    worst.add(c, holds, low[c], static_cast<float>(truth));
  }
  record(worst.holds, worst.ratio, [&] {
    return sides_text(of, node, worst, "lower bound", "true contribution",
                      of.at.truth.open(node)[std::size_t(worst.channel)]);
  });
}

BothSides order_sides(const PointAnswers& of, std::uint32_t node) {
  const glm::vec3 low = of.judged.tree.lower_bound(node, of.at.point);
  BothSides sides{"the lower bound", "truth", {}, {}, number_row("lower bound", low)};
  for (int c = 0; c < 3; ++c) {
    sides.left[std::size_t(c)] = exact_of(low[c]);
    sides.right[std::size_t(c)] = static_cast<double>(of.at.truth.exact_open(node, c));
  }
  return sides;
}

} // namespace

const PropertyInfo property::bounds_are_ordered{
    .name = "bounds-are-ordered",
    .statement = "A cluster contributes between its lower and its upper bound, if nothing is "
                 "occluded.",
    .formula = "lower bound <= sum of contributions, per channel; lower bound <= bound",
    .needs = only(Part::bounds) | only(Part::lower_bounds),
    .of_clusters = each_cluster<check_order>,
    .sides = order_sides,
};

} // namespace lightcuts::oracle
