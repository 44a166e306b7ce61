// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bound.h>
#include <oracle/properties/both_sides.h>
#include <oracle/properties/bounds/worst_channel.h>
#include <oracle/properties/text_rows.h>

namespace lightcuts::oracle {
namespace {

void check_refinement(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  if (of.topology().is_leaf(node)) return;
  const std::span<const glm::vec3> bounds = of.bounds();
  WorstChannel worst;
  const auto nodes = of.topology().children(node);
  for (int c = 0; c < 3; ++c) {
    double children = 0;
    for (const std::uint32_t child : nodes) children += bounds[child][c];
    // Each bound may exceed the real one by bound_excess and one subnormal.
    const double allowed =
        double(bounds[node][c]) * (1 + bound_excess) + double(nodes.size()) * 0x1p-149;
    worst.add(c, children <= allowed, children, allowed);
  }
  record(worst.holds, worst.ratio, [&] {
    return sides_text(of, node, worst, "children's bounds", "bound", bounds[node][worst.channel]);
  });
}

BothSides refinement_sides(const PointAnswers& of, std::uint32_t node) {
  BothSides sides = bound_sides(of, node);
  sides.left_name = "the children's bounds";
  sides.left = {0, 0, 0};
  for (const std::uint32_t child : of.topology().children(node)) {
    const glm::vec3& bound = of.bounds()[child];
    for (int c = 0; c < 3; ++c) sides.left[std::size_t(c)] += exact_of(bound[c]);
    sides.rows += number_row(fmt::format("bound of node {}", child), bound);
  }
  return sides;
}

} // namespace

const PropertyInfo property::bound_shrinks_on_refinement{
    .name = "bound-shrinks-on-refinement",
    .statement = "The bounds of children sum to no more than their parent's.",
    .formula = "sum of the children's bounds <= bound (1 + 2^-22), the rounding of bounds",
    .promise = Promise::library,
    .needs = only(Part::bounds),
    .of_clusters = each_cluster<check_refinement>,
    .sides = refinement_sides,
};

} // namespace lightcuts::oracle
