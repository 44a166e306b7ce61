// SPDX-License-Identifier: MIT
#include <oracle/explain/cluster_parts.h>
#include <oracle/explain/explain_parts.h>
#include <oracle/explain/failing_place.h>
#include <oracle/explain/suprema.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

std::string number_line(const char* name, double value, const char* note = "") {
  return line(name, fmt::format("{:.17g}", value), note);
}

std::string box_and_suprema(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  const TreeNode& n = tree.node(node);
  if (n.is_mixed())
    return box_and_suprema(tree, n.first_child, point) +
           box_and_suprema(tree, n.first_child + 1, point);
  const Suprema sup = suprema_at(tree, node, point);
  std::string text = fmt::format("the box of {} {} light{}, and suprema over it\n", n.light_count,
                                 name_of(n.kind()), n.light_count == 1 ? "" : "s");
  text += line("box from", text_of(n.box.lo)) + line("to", text_of(n.box.hi));
  if (!is_at_infinity(n.kind()))
    text += number_line("min |q|", sup.min_distance,
                        sup.min_distance == 0 ? "the point is in the box" : "");
  text += number_line("max n.l falloff", sup.max_cosine_falloff, "both factors in one");
  text +=
      number_line("max falloff", sup.max_falloff) + number_line("max emission", sup.max_emission);
  if (point.material().is_glossy()) text += number_row("max lobe n.l falloff", sup.shine);
  return text + number_row("intensity", n.intensity);
}

std::string cluster_text(const PointAnswers& of, Property property, std::uint32_t node) {
  const PointCase& at = of.at;
  const glm::vec3& bound = of.bounds()[node];
  const LibraryCluster cluster(of.judged, at, node);
  std::string text = cluster_head(at, node) + lights_text(at, node) + "\n";
  if (!cluster.tree->empty()) text += box_and_suprema(*cluster.tree, cluster.node, at.point);
  text +=
      "bound = intensity max emission (diffuse/pi max(n.l falloff) + max(lobe n.l falloff))\n\n";
  const auto others = info(property).sides;
  const BothSides sides = others != nullptr ? others(of, node) : bound_sides(of, node);
  text += channel_head() + row_of("truth, 700 bits",
                                  [&](int c) { return text_of(at.truth.exact_open(node, c), 20); });
  text += sides.rows + number_row("the library's bound", cluster.bound(at.point));
  text += number_row("the subject's bound", bound);
  text += truth_over(at, node, bound);
  return text + "\n" + parting(cluster, sides, others == nullptr, at, node);
}

} // namespace

std::string explain_cluster(const PointAnswers& of, Property property) {
  const auto node = failing_cluster(of, property);
  return node ? cluster_text(of, property, *node) : std::string();
}

} // namespace lightcuts::oracle
