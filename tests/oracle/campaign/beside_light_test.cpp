// SPDX-License-Identifier: MIT
#include <oracle/campaign/beside_light.h>

#include <algorithm>

#include <gtest/gtest.h>
#include <oracle/campaign/check.h>
#include <oracle/campaign/scene_case.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/library_subject.h>

#include <tests/oracle/support/small_scene.h>

namespace lightcuts::oracle {
namespace {

TEST(ViewBesideLight, FacesTheLightFromOutsideAClusterOfIt) {
  const Scene scene = floor_scene(40);
  const auto tree = library_subject()->build(scene.lights, 1);
  const Topology topology = *read_topology(tree->claim(), scene.lights.size()).topology;
  const Box all = tree->library_tree()->node(0).box;
  int outside_of_all = 0;
  for (std::uint64_t random = 0; random < 200; ++random) {
    const gen::View view = view_beside_light(scene.lights, topology, random, {});
    const auto faces = [&](const Light& light) {
      const glm::vec3 q = light.position - view.position;
      for (int i = 0; i < 3; ++i)
        if (view.normal[i] == 0 && q[i] != 0) return false;
      return glm::dot(q, view.normal) > 0;
    };
    EXPECT_TRUE(std::any_of(scene.lights.begin(), scene.lights.end(), faces)) << random;
    for (int i = 0; i < 3; ++i)
      outside_of_all += view.position[i] < all.lo[i] || view.position[i] > all.hi[i] ? 1 : 0;
  }
  EXPECT_GT(outside_of_all, 20);
}

TEST(ViewBesideLight, StaysWhereTheCameraSeesIfTheLightIsNowhere) {
  LightSet lights;
  lights.add_directional({0, 0, 1}, glm::vec3(1));
  const auto tree = library_subject()->build(lights, 1);
  const Topology topology = *read_topology(tree->claim(), 1).topology;
  gen::View view;
  view.position = {1, 2, 3};
  EXPECT_EQ(view_beside_light(lights, topology, 7, view), view);
}

// The light that is left out shows only beside it.
TEST(Check, JudgesBesideLights) {
  const Scene scene = floor_scene(1025);
  const SceneView view(scene);
  CheckConfig config;
  config.pairs = 2'000'000;
  config.threads = 2;
  const auto mutant = mutant_named("last-of-1025-lights")->subject();
  const CheckResult result = check(view, *mutant, config);
  constexpr auto p = Property::bound_dominates_contribution;
  ASSERT_GT(result.tally[p].violations, 0U);
  const auto found = counterexample_of(*mutant, view, config, result);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->property, p);
  EXPECT_TRUE(failure_of(*mutant, found->property, found->on));
  EXPECT_EQ(check(view, *library_subject(), config).tally.violations(), 0U);
}

} // namespace
} // namespace lightcuts::oracle
