// SPDX-License-Identifier: MIT
#include <lightcuts/core/methods/unscaled_rules.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/cut_promises.h>

namespace lightcuts {
namespace {

RC_GTEST_PROP(UnscaledRules, KeepAllPromisesOfACut, ()) {
  const CutCase given = *cut_case();
  RC_ASSERT(broken_promise<UnscaledRules>(given) == "");
}

TEST(UnscaledRules, EstimateByTheRepresentativeAlone) {
  LightSet lights;
  lights.add_omni({0, 0, 2}, {1, 0, 0});
  lights.add_omni({0, 0, 4}, {0, 0, 3});
  const LightTree tree = build(lights);
  const ShadingPoint point({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1), {}});
  const Light& light = lights[tree.node(0).representative];
  EXPECT_EQ(UnscaledRules::estimate(tree, 0, point, NoLobe(), glm::vec3(0)),
            transfer(point, light) * glm::dvec3(light.intensity));
}

} // namespace
} // namespace lightcuts
