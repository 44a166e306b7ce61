// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include <oracle/properties/tree_case.h>

namespace lightcuts::oracle {
namespace {

void check_representatives(const TreeCase& of, const Recorder& record) {
  if (of.topology == nullptr) return;
  const Topology& tree = *of.topology;
  const auto nodes = tree.parents_first();
  for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
    const std::uint32_t representative = tree.representative(*i);
    if (representative == TreeClaim::unsaid) continue;
    const auto lights = tree.lights(*i);
    const auto children = tree.children(*i);
    const bool belongs = std::find(lights.begin(), lights.end(), representative) != lights.end() ||
                         std::any_of(children.begin(), children.end(), [&](std::uint32_t child) {
                           return tree.representative(child) == representative;
                         });
    record(belongs, [&] {
      return fmt::format("node {}: representative {} is not of this cluster", *i, representative);
    });
  }
}

} // namespace

const PropertyInfo property::representative_belongs{
    .name = "representative-belongs",
    .statement = "A cluster's representative is one of its lights, and that of one of its "
                 "children.",
    .formula = "by induction from the leaves",
    .of_tree = check_representatives,
};

} // namespace lightcuts::oracle
