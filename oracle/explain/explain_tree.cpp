// SPDX-License-Identifier: MIT
#include <oracle/properties/case_properties.h>

#include <oracle/explain/explain_parts.h>

namespace lightcuts::oracle {
namespace {

// Larger trees are of counterexamples that could not be shrunk.
constexpr std::size_t most_nodes = 60;

bool is_about_trees(Property property) {
  return property == Property::tree_partitions_lights ||
         property == Property::tree_conserves_intensity ||
         property == Property::representative_belongs || property == Property::tree_equals_naive;
}

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

/// The intensities of a node, side by side with what its lights sum to.
std::string intensity_lines(const Topology& tree, const LightSet& lights, std::uint32_t node) {
  const glm::dvec3 said = tree.intensity(node).value_or(glm::dvec3(0));
  std::array<Exact, 3> sum{0, 0, 0};
  for (const std::uint32_t light : tree.all_lights(node))
    for (int c = 0; c < 3; ++c) sum[std::size_t(c)] += Exact(lights[light].intensity[c]);
  return number_row("intensity", said) +
         row_of("its lights' total", [&](int c) { return text_of(sum[std::size_t(c)]); });
}

std::string defect_of(const TreeClaim& claim, const LightSet& lights, Property property) {
  Tally tally;
  const std::optional<Topology> topology = check_tree(claim, lights, 0, tally);
  if (!topology) return tally[Property::tree_partitions_lights].first_violation;
  check_cost(*topology, lights, 0, tally);
  return tally[property].first_violation;
}

} // namespace

std::string explain_tree(const TreeClaim& claim, const LightSet& lights, Property property) {
  const TopologyReading reading = read_topology(claim, lights.size());
  if (!is_about_trees(property) && reading.topology) return {};
  std::string text;
  for (std::size_t i = 0; i < lights.size() && i < most_nodes; ++i)
    text += wrapped(fmt::format("light {}: {}", i, text_of(lights[i])));
  text += fmt::format("\ntree of {} nodes\n", claim.nodes.size());
  for (std::uint32_t i = 0; i < claim.nodes.size() && i < most_nodes; ++i) {
    text += node_line(claim, i);
    if (property == Property::tree_conserves_intensity && reading.topology &&
        reading.topology->intensity(i))
      text += intensity_lines(*reading.topology, lights, i);
  }
  if (claim.nodes.size() > most_nodes)
    text += fmt::format("  ... and {} more\n", claim.nodes.size() - most_nodes);
  return text + "\n" + wrapped("they part here: " + defect_of(claim, lights, property));
}

} // namespace lightcuts::oracle
