// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/bound_sweep.h>

#include <oracle/properties/bounds/bound_dominates_contribution.h>

namespace lightcuts::oracle {
namespace {

/// The tree as FastTruth wants it, parents before children; nothing where it is not binary or a
/// leaf has not one light.
std::optional<std::vector<FastNode>> fast_nodes(const Topology& topology) {
  std::vector<FastNode> nodes(topology.size());
  for (std::uint32_t i = 0; i < topology.size(); ++i) {
    const auto children = topology.children(i);
    const auto lights = topology.lights(i);
    if (children.empty() && lights.size() == 1)
      nodes[i] = {lights[0]};
    else if (children.size() == 2 && children[0] > i && children[1] > i)
      nodes[i] = {children[0], children[1]};
    else
      return std::nullopt;
  }
  return nodes;
}

} // namespace

BoundSweep::BoundSweep(const Topology& topology, const LightSet& lights)
    : topology_(topology), lights_(lights), bounds_(topology.size()) {
  const std::vector<Light> list(lights.begin(), lights.end());
  if (!FastTruth::supports(list, Material{})) return;
  if (const auto nodes = fast_nodes(topology)) truth_.emplace(list, *nodes, lights.min_distance());
}

void BoundSweep::check(SubjectTree& tree, const ShadingPoint& point, std::uint64_t place,
                       Tally& tally) {
  tree.bounds(point, bounds_);
  truth_->evaluate(point);
  compare(bounds_, *truth_, comparison_);
  PropertyCount& count = tally[Property::bound_dominates_contribution];
  count.hold(bounds_.size() - comparison_.undecided.size(), comparison_.worst_ratio);
  for (const std::uint32_t node : comparison_.undecided)
    check_bound(topology_, lights_, point, node, bounds_[node], Recorder(count, place));
}

} // namespace lightcuts::oracle
