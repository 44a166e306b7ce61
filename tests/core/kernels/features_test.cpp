// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/features.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/cut_promises.h>

namespace lightcuts {
namespace {

RC_GTEST_PROP(Features, OfANarrowerKernelGiveTheSameBits, ()) {
  const CutCase given = *cut_case();
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  const bool occludes = *rc::gen::arbitrary<bool>();
  CutConfig config = given.config;
  config.unoccluded = !occludes;
  CutSelector general(tree, config);
  const Cut expected = general(point, given.visibility());
  with_features(tree.lights(), occludes, [&](auto features) {
    BasicCutSelector<BasicLightcutsRules<decltype(features)>> narrow(tree, config);
    const Cut cut = narrow(point, given.visibility());
    RC_ASSERT(cut.radiance == expected.radiance);
    RC_ASSERT(cut.certified_error == expected.certified_error);
    RC_ASSERT(cut.shadow_rays == expected.shadow_rays);
    RC_ASSERT(cut.clusters.size() == expected.clusters.size());
    for (std::size_t i = 0; i < cut.clusters.size(); ++i)
      RC_ASSERT(cut.clusters[i].node == expected.clusters[i].node);
  });
}

TEST(Features, AreAsNarrowAsTheLights) {
  LightSet lights;
  lights.add_oriented({}, {0, 0, 1}, glm::vec3(1));
  with_features(lights, false, [](auto features) {
    using F = decltype(features);
    EXPECT_TRUE(F::has(LightKind::oriented));
    EXPECT_TRUE(F::uniform);
    EXPECT_FALSE(F::has(LightKind::omni) || F::clamps || F::occludes);
  });
  lights.set_min_distance(1);
  with_features(lights, true, [](auto features) {
    EXPECT_TRUE(decltype(features)::clamps && decltype(features)::occludes);
  });
  lights.add_omni({}, glm::vec3(1));
  with_features(lights, true,
                [](auto features) { EXPECT_EQ(decltype(features)::kinds, all_light_kinds); });
}

} // namespace
} // namespace lightcuts
