// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <lightcuts/core/numerics/angle.h>
#include <oracle/explain/cluster_parts.h>
#include <oracle/explain/explain_parts.h>
#include <oracle/explain/failing_place.h>
#include <oracle/explain/suprema.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

/// A factor of both bounds; of the block it is to be no less, or, of a distance, no more.
std::string two_factors(const char* name, double of_point, double of_block, const char* note = "") {
  return line(name, fmt::format("{:.17g}", of_point),
              fmt::format("{:<24} {}", fmt::format("{:.17g}", of_block), note));
}

std::string cone_line(const char* name, const OrientationCone& cone) {
  const Angle angle = cone.half_angle();
  return line(name, text_of(cone.axis),
              fmt::format("turned by up to {:.9g} rad", std::atan2(angle.sin, angle.cos)));
}

std::string block_lines(const ShadingBlock& block, std::size_t points) {
  std::string text = fmt::format("the block of {} point{}\n", points, points == 1 ? "" : "s");
  text += line("points from", text_of(block.positions().lo)) +
          line("to", text_of(block.positions().hi));
  text += cone_line("normals", block.directions().normals);
  if (!block.material().is_glossy()) return text;
  return text + cone_line("viewers", block.directions().viewers) +
         cone_line("mirrored", block.directions().mirrors);
}

std::string suprema_text(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const ShadingBlock& block) {
  const TreeNode& n = tree.node(node);
  if (n.is_mixed())
    return suprema_text(tree, n.first_child, point, block) +
           suprema_text(tree, n.first_child + 1, point, block);
  const Suprema one = suprema_at(tree, node, point), all = suprema_over(tree, node, block);
  std::string text = fmt::format("the box of {} {} light{}\n", n.light_count, name_of(n.kind()),
                                 n.light_count == 1 ? "" : "s");
  text += line("box from", text_of(n.box.lo)) + line("to", text_of(n.box.hi));
  text += line("suprema over it", "from this point", "from the block");
  if (!is_at_infinity(n.kind())) text += two_factors("min |q|", one.min_distance, all.min_distance);
  text += two_factors("max n.l falloff", one.max_cosine_falloff, all.max_cosine_falloff,
                      "both factors in one");
  text += two_factors("max falloff", one.max_falloff, all.max_falloff);
  text += two_factors("max emission", one.max_emission, all.max_emission);
  const Material &own = point.material(), &most = block.material();
  for (int c = 0; c < 3; ++c) {
    const char* channel = c == 0 ? "r" : c == 1 ? "g" : "b";
    if (own.is_glossy() || most.is_glossy())
      text += two_factors("max lobe n.l falloff", one.shine[c], all.shine[c], channel);
    text += two_factors("diffuse", own.diffuse[c], most.diffuse[c], channel);
  }
  return text + number_row("intensity", n.intensity);
}

/// The answers of a block as those of bounds are: both sides of its inequality.
BothSides block_sides(const BlockAnswers& of, std::uint32_t node) {
  BothSides sides{"truth", "the subject's bound of the block", {}, {}};
  for (int c = 0; c < 3; ++c) {
    sides.left[std::size_t(c)] = of.point.at.truth.exact_open(node, c);
    sides.right[std::size_t(c)] = of.bounds[node][c];
  }
  return sides;
}

} // namespace

std::string explain_block(const BlockAnswers& of, std::span<const ShadingPoint> points,
                          Property property) {
  const auto failing = failing_cluster(of, property);
  if (!failing) return {};
  const std::uint32_t node = *failing;
  const PointCase& at = of.point.at;
  const LibraryCluster cluster(of.point.judged, at, node);
  const ShadingBlock block(points);
  std::string text = cluster_head(at, node) + lights_text(at, node) + "\n";
  text += block_lines(block, points.size());
  if (!cluster.tree->empty()) text += suprema_text(*cluster.tree, cluster.node, at.point, block);
  text +=
      "bound = intensity max emission (diffuse/pi max(n.l falloff) + max(lobe n.l falloff))\n\n";
  text += channel_head() + row_of("truth, 700 bits",
                                  [&](int c) { return text_of(at.truth.exact_open(node, c), 20); });
  text += number_row("library, this point", cluster.bound(at.point));
  text += number_row("library, the block", cluster.bound(block));
  text += number_row("subject, the block", of.bounds[node]);
  text += truth_over(at, node, of.bounds[node]);
  return text + "\n" + parting(cluster, block_sides(of, node), true, at, node);
}

} // namespace lightcuts::oracle
