// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/cluster_kernel.h>

#include <rapidcheck/gtest.h>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/methods/all_methods.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/cut_promises.h>

namespace lightcuts {
namespace {

const ClusterKernel& kernel_by(const Method& method) {
  return kernel_for(all_light_kinds, method->rules);
}

RC_GTEST_PROP(KernelFor, OneKindGivesTheBitsOfTheOneForAny, ()) {
  const CutCase given = *cut_case();
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  CutConfig config = given.config;
  config.unoccluded = *rc::gen::arbitrary<bool>();
  CutSelector general(tree, config, kernel_for(all_light_kinds));
  const Cut expected = general(point, given.visibility());
  CutSelector narrow(tree, config);
  const Cut cut = narrow(point, given.visibility());
  RC_ASSERT(cut.radiance == expected.radiance);
  RC_ASSERT(cut.certified_error == expected.certified_error);
  RC_ASSERT(cut.shadow_rays == expected.shadow_rays);
  RC_ASSERT(cut.clusters.size() == expected.clusters.size());
  for (std::size_t i = 0; i < cut.clusters.size(); ++i) {
    RC_ASSERT(cut.clusters[i].node == expected.clusters[i].node);
    RC_ASSERT(cut.clusters[i].bound == expected.clusters[i].bound);
    RC_ASSERT(cut.clusters[i].estimate == expected.clusters[i].estimate);
  }
}

TEST(KernelFor, OneKindIsAnotherThanTheOneForAny) {
  for (int kind = 0; kind < light_kind_count; ++kind)
    EXPECT_NE(&kernel_for(only(LightKind(kind))), &kernel_for(all_light_kinds));
}

RC_GTEST_PROP(KernelFor, RulesOfEveryMethodKeepsAllPromisesOfACut, ()) {
  const CutCase given = *cut_case();
  for (const Method method : all_methods)
    if (method->cuts) RC_ASSERT(broken_promise(given, kernel_by(method)) == "");
}

/// Two omni lights over a point, and a kernel by the method's rules.
struct TwoLights {
  LightSet lights;
  LightTree tree;
  ShadingPoint point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}}};

  TwoLights() {
    lights.add_omni({0, 0, 2}, {1, 0, 0});
    lights.add_omni({0, 0, 4}, {0, 0, 3});
    tree = build(lights);
  }
  [[nodiscard]] const Light& representative() const { return lights[tree.node(0).representative]; }
  [[nodiscard]] glm::dvec3 estimate(const Method& method) const {
    return kernel_by(method).estimate(tree, 0, point, glm::vec3(0));
  }
};

TEST(KernelFor, PaperEstimatesByTheRepresentativeScaled) {
  const TwoLights two;
  EXPECT_EQ(two.estimate(methods::paper),
            transfer(two.point, two.representative()) * glm::dvec3(1, 0, 3));
}

TEST(KernelFor, UnscaledEstimatesByTheRepresentativeAlone) {
  const TwoLights two;
  EXPECT_EQ(two.estimate(methods::unscaled),
            transfer(two.point, two.representative()) * glm::dvec3(two.representative().intensity));
}

RC_GTEST_PROP(NoSpecularBound, IsNeverTighterThanTheJointOne, ()) {
  const CutCase given = *cut_case();
  const ShadingPoint point = given.scene.view.point();
  const LightTree tree = build(given.scene.light_set());
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const glm::vec3 loose = contribution_bound(tree, i, point, BoundRule::no_specular);
    const glm::vec3 tight = contribution_bound(tree, i, point);
    // Both are rounded up, in their own ways.
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(tight[c] <= loose[c] * float(1 + 2 * bound_excess) + 0x1p-149F);
  }
}

TEST(NoSpecularBound, OfALobeThatLooksElsewhereIsItsPeak) {
  LightSet lights;
  lights.add_omni({2, 0, 0.5F}, glm::vec3(1));
  const LightTree tree = build(lights);
  // The mirror direction is that of the normal, far from the light.
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1},
                           diffuse_and_phong(glm::vec3(0), glm::vec3(1), 100));
  const Phong& phong = std::get<Phong>(point.material().lobe);
  const double cosine_over_distance2 = 0.5 / std::pow(4.25, 1.5);
  EXPECT_NEAR(contribution_bound(tree, 0, point, BoundRule::no_specular).x,
              phong.normalisation() * cosine_over_distance2, 1e-6);
  EXPECT_LT(contribution_bound(tree, 0, point).x, 1e-20F);
}

} // namespace
} // namespace lightcuts
