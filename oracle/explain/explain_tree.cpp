// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <oracle/cases/case_text.h>
#include <oracle/explain/explain_parts.h>
#include <oracle/properties/judge.h>
#include <oracle/properties/tree_case.h>

namespace lightcuts::oracle {
namespace {

// Larger trees are of counterexamples that could not be shrunk.
constexpr std::size_t most_nodes = 60;

std::string list_text(const std::vector<std::uint32_t>& list, std::uint32_t first,
                      std::uint32_t count) {
  std::string text;
  for (std::uint64_t i = first; i < std::uint64_t(first) + count; ++i) {
    if (i >= list.size()) return text + " (beyond the list)";
    text += fmt::format(" {}", list[i]);
  }
  return text;
}

std::string node_line(const TreeClaim& claim, std::size_t i) {
  const TreeClaim::Node& n = claim.nodes[i];
  std::string text = fmt::format("  node {}:", i);
  if (n.child_count > 0)
    text += " children" + list_text(claim.children, n.first_child, n.child_count);
  else
    text += " lights" + list_text(claim.lights, n.first_light, n.light_count);
  if (n.representative != TreeClaim::unsaid)
    text += fmt::format(", representative {}", n.representative);
  return wrapped(text);
}

std::string defect_of(const TreeClaim& claim, const LightSet& lights, Property property) {
  Tally tally;
  (void)Judge(0, 0, tally, property).tree(claim, lights);
  return tally[property].first_violation;
}

} // namespace

std::string explain_tree(const TreeClaim& claim, const LightSet& lights, Property property) {
  const TopologyReading reading = read_topology(claim, lights.size());
  const PropertyInfo& about = info(property);
  if (about.of_tree == nullptr && reading.topology) return {};
  if (!reading.topology) property = Property::tree_partitions_lights;
  std::string text;
  for (std::size_t i = 0; i < lights.size() && i < most_nodes; ++i)
    text += wrapped(fmt::format("light {}: {}", i, text_of(lights[i])));
  text += fmt::format("\ntree of {} nodes\n", claim.nodes.size());
  for (std::uint32_t i = 0; i < claim.nodes.size() && i < most_nodes; ++i) {
    text += node_line(claim, i);
    if (about.node_rows != nullptr && reading.topology)
      text += about.node_rows({lights, reading.defect, &*reading.topology}, i);
  }
  if (claim.nodes.size() > most_nodes)
    text += fmt::format("  ... and {} more\n", claim.nodes.size() - most_nodes);
  return text + "\n" + wrapped("they part here: " + defect_of(claim, lights, property));
}

} // namespace lightcuts::oracle
