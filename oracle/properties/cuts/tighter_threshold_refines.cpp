// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

/// Whether each cluster of `fine` lies in one of `coarse`, both being cuts.
bool refines(const Topology& tree, const std::vector<std::uint32_t>& fine,
             const std::vector<std::uint32_t>& coarse) {
  std::vector<bool> allowed(tree.size(), false);
  for (const std::uint32_t node : coarse)
    if (node < tree.size()) allowed[node] = true;
  for (const std::uint32_t node : tree.parents_first())
    if (allowed[node])
      for (const std::uint32_t child : tree.children(node)) allowed[child] = true;
  return std::all_of(fine.begin(), fine.end(),
                     [&](std::uint32_t node) { return node < tree.size() && allowed[node]; });
}

TwoCuts two_thresholds(const PointAnswers&, const CutConfig& config) {
  TwoCuts cuts{{config}, {config}};
  cuts.one.config.black_level = cuts.other.config.black_level = 0;
  cuts.other.config.threshold /= 4;
  return cuts;
}

void check_refinement(const PointAnswers& of, const CutConfig& config, const Recorder& record) {
  const auto [coarse, fine] = two_thresholds(of, config);
  if (fine.config.threshold == 0) return;
  const auto nodes_of = [&](const ChosenCut& chosen) {
    std::vector<std::uint32_t> nodes;
    for (const CutCluster& c : of.select(chosen.config).clusters) nodes.push_back(c.node);
    return nodes;
  };
  const auto coarse_nodes = nodes_of(coarse), fine_nodes = nodes_of(fine);
  record(refines(of.topology(), fine_nodes, coarse_nodes), [&, one = coarse, other = fine] {
    return fmt::format("{}: the cut of {} clusters at threshold {} does not refine that of {} at "
                       "{}",
                       of.at.text(), fine_nodes.size(), other.config.threshold, coarse_nodes.size(),
                       one.config.threshold);
  });
}

} // namespace

const PropertyInfo property::tighter_threshold_refines{
    .name = "tighter-threshold-refines",
    .statement = "The cut of a smaller threshold refines that of a larger one.",
    .formula = "each cluster of the one lies in a cluster of the other",
    .needs = only(Part::cuts),
    .of_point = check_refinement,
    .two_cuts = two_thresholds,
};

} // namespace lightcuts::oracle
