// SPDX-License-Identifier: MIT
#include <oracle/campaign/scene_case.h>

#include <gtest/gtest.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <oracle/cases/random_pixels.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

struct Desk {
  Scene scene = make_builtin("desk");
  SceneView view{scene};
  CheckConfig config;

  Desk() {
    config.seed = 5;
    config.tree_seed = 9;
    config.cut = {0.05F, 40, 0.001F};
    config.pairs = 20'000;
    config.threads = 2;
  }
};

TEST(SceneCase, IsThePointWithAllLights) {
  const Desk desk;
  const Case on = case_of(*library_subject(), desk.view, desk.config, 17);
  const VisiblePoint p = random_point(desk.view, 5, 17);
  ASSERT_EQ(on.views.size(), 1U);
  EXPECT_EQ(on.views[0].view.position, p.point.position());
  EXPECT_EQ(on.views[0].view.normal, p.point.normal());
  EXPECT_EQ(on.views[0].view.to_viewer, p.point.to_viewer());
  EXPECT_EQ(on.views[0].view.material, p.point.material());
  ASSERT_EQ(on.lights.size(), desk.scene.lights.size());
  std::vector<std::uint32_t> hidden;
  for (std::uint32_t i = 0; i < on.lights.size(); ++i) {
    EXPECT_EQ(on.lights[i], desk.scene.lights[i]);
    if (!desk.view.sees(p, i)) hidden.push_back(i);
  }
  EXPECT_EQ(on.views[0].hidden, hidden);
  EXPECT_EQ(on.cut, desk.config.cut);
  EXPECT_EQ(on.seed, 9U);
  EXPECT_TRUE(on.triangles.empty());
}

TEST(SceneCase, OfAMutantFailsAndShrinks) {
  const Desk desk;
  for (const char* name : {"heap-inverted", "intensity-of-representative"}) {
    const auto subject = mutant_named(name)->subject();
    const CheckResult result = check(desk.view, *subject, desk.config);
    const auto found = counterexample_of(*subject, desk.view, desk.config, result);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->on.lights.size(), desk.scene.lights.size());
    EXPECT_EQ(found->index, result.tally[found->property].first_place);
    const Counterexample small = shrunk(*subject, *found);
    EXPECT_LE(small.on.lights.size(), 6U) << name;
    EXPECT_TRUE(failure_of(*subject, small.property, small.on)) << name;
  }
}

TEST(SceneCase, OfABlockHasTheNeighboursThatBoundedTogetherFail) {
  const Desk desk;
  const auto subject = mutant_named("block-corner-forgotten")->subject();
  CheckConfig config = desk.config;
  config.pairs = 400'000;
  const CheckResult result = check(desk.view, *subject, config);
  ASSERT_GT(result.tally[Property::block_bound_dominates].violations, 0U);
  const auto found = counterexample_of(*subject, desk.view, config, result);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->property, Property::block_bound_dominates);
  EXPECT_TRUE(is_of_block(found->index));
  EXPECT_GT(found->on.views.size(), 1U);
}

TEST(SceneCase, IsNoneOfTheLibrary) {
  const Desk desk;
  const auto subject = library_subject();
  const CheckResult result = check(desk.view, *subject, desk.config);
  EXPECT_FALSE(counterexample_of(*subject, desk.view, desk.config, result));
}

TEST(SceneCase, IsNoneOfWhatTakesTheGeometry) {
  const Desk desk;
  CheckResult result = check(desk.view, *library_subject(), desk.config);
  result.tally[Property::occlusion_equals_brute_force].record(
      false, 0, no_ratio, [] { return std::string("blocked"); });
  EXPECT_FALSE(counterexample_of(*library_subject(), desk.view, desk.config, result));
}

} // namespace
} // namespace lightcuts::oracle
