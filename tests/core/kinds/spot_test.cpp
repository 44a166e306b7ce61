// SPDX-License-Identifier: MIT
#include <lightcuts/core/kinds/spot.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/numbers/dice.h>

namespace lightcuts {
namespace {

/// The largest emission towards x of the lights below a node.
double largest_emission(const LightTree& tree, std::uint32_t node, const glm::vec3& x) {
  const TreeNode& n = tree.node(node);
  if (n.is_leaf()) return Spot::emission(tree.lights()[n.representative], x);
  return std::max(largest_emission(tree, n.first_child, x),
                  largest_emission(tree, n.first_child + 1, x));
}

// Cones from one float's step up, whose rims pass near x: there bound and emission have least room.
TEST(Spot, of_any_cone_is_bounded_over_its_cluster) {
  gen::Dice dice(5);
  int lit = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 x = dice.in_cube();
    LightSet lights;
    for (int k = 0; k < 6; ++k) {
      const glm::vec3 y = dice.in_cube();
      const glm::dvec3 way = glm::normalize(glm::dvec3(x) - glm::dvec3(y));
      const double outer = std::exp2(dice.uniform(-13, 0));
      const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(dice.unit_vector())));
      // Off the axis by the outer angle, or a little less.
      const double off = outer * (dice.one_in(2) ? 1 - 0x1p-24 * dice.uniform(0, 4) : 0.999);
      const glm::vec3 axis(way * std::cos(off) + side * std::sin(off));
      const double inner = outer * (dice.one_in(2) ? 1 - 0x1p-20 : dice.uniform(0, 0.99));
      lights.add_spot(y, glm::vec3(glm::normalize(glm::dvec3(axis))), glm::vec3(1), float(inner),
                      float(outer));
    }
    const LightTree tree = build(lights);
    for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) {
      const double most = largest_emission(tree, node, x);
      lit += most > 0 ? 1 : 0;
      ASSERT_GE(Spot::max_emission(tree.emission(node), DifferenceBox(x, tree.node(node).box)),
                most)
          << i << ", node " << node;
    }
  }
  EXPECT_GT(lit, 10000);
}

} // namespace
} // namespace lightcuts
