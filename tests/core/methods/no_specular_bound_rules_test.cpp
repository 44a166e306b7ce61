// SPDX-License-Identifier: MIT
#include <lightcuts/core/methods/no_specular_bound_rules.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/cut_promises.h>

namespace lightcuts {
namespace {

RC_GTEST_PROP(NoSpecularBoundRules, KeepAllPromisesOfACut, ()) {
  const CutCase given = *cut_case();
  RC_ASSERT(broken_promise<NoSpecularBoundRules>(given) == "");
}

RC_GTEST_PROP(NoSpecularBoundRules, AreNeverTighterThanThoseOfLightcuts, ()) {
  const CutCase given = *cut_case();
  const ShadingPoint point = given.scene.view.point();
  const LightTree tree = build(given.scene.light_set());
  std::visit(
      [&](const auto& lobe) {
        for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
          const glm::vec3 loose = NoSpecularBoundRules::bound(tree, i, point, lobe);
          const glm::vec3 tight = LightcutsRules::bound(tree, i, point, lobe);
          // Both are rounded up, in their own ways.
          for (int c = 0; c < 3; ++c)
            RC_ASSERT(tight[c] <= loose[c] * float(1 + 2 * bound_excess) + 0x1p-149F);
        }
      },
      point.material().lobe);
}

TEST(NoSpecularBoundRules, BoundALobeThatLooksElsewhereByItsPeak) {
  LightSet lights;
  lights.add_omni({2, 0, 0.5F}, glm::vec3(1));
  const LightTree tree = build(lights);
  // The mirror direction is that of the normal, far from the light.
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1},
                           diffuse_and_phong(glm::vec3(0), glm::vec3(1), 100));
  const Phong& phong = std::get<Phong>(point.material().lobe);
  const double cosine_over_distance2 = 0.5 / std::pow(4.25, 1.5);
  EXPECT_NEAR(NoSpecularBoundRules::bound(tree, 0, point, phong).x,
              phong.normalisation() * cosine_over_distance2, 1e-6);
  EXPECT_LT(LightcutsRules::bound(tree, 0, point, phong).x, 1e-20F);
}

} // namespace
} // namespace lightcuts
