// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bound.h>

#include <bit>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

void check_equals_one_by_one(const gen::Scene& scene) {
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  std::vector<glm::vec3> bounds(tree.nodes().size(), glm::vec3(-1));
  contribution_bounds(tree, point, bounds);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    const glm::vec3 one = contribution_bound(tree, i, point);
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(std::bit_cast<std::uint32_t>(bounds[i][c]) == std::bit_cast<std::uint32_t>(one[c]));
  }
}

RC_GTEST_PROP(ContributionBounds, AreThoseOfTheNodesOneByOneToTheBit, ()) {
  check_equals_one_by_one(*gen::scene());
}

RC_GTEST_PROP(ContributionBounds, OfOmniLightsOnDiffuseSurfacesAreTheSameToTheBit, ()) {
  check_equals_one_by_one(*gen::scene_of(LightKind::omni, 0, *rc::gen::arbitrary<bool>()));
}

TEST(ContributionBounds, OfNoLightsAreNone) {
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  contribution_bounds(LightTree(), point, {});
}

} // namespace
} // namespace lightcuts
