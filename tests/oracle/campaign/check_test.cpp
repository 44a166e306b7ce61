// SPDX-License-Identifier: MIT
#include <oracle/campaign/check.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <oracle/mutants/mutants.h>

#include <tests/oracle/support/made_subject.h>
#include <tests/oracle/support/small_scene.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto occlusion_checked = Property::occlusion_equals_brute_force;

CheckConfig check_config(std::uint64_t pairs, unsigned threads = 2) {
  CheckConfig config;
  config.pairs = pairs;
  config.threads = threads;
  return config;
}

CheckResult check_library(const Scene& scene, const CheckConfig& config) {
  const SceneView view(scene);
  return check(view, *library_subject(), config);
}

TEST(Check, FindsNothingWrongWithTheLibrary) {
  const CheckResult result = check_library(shaded_floor_scene(40), check_config(20'000));
  EXPECT_THAT(violated(result.tally), IsEmpty());
  for (const Property p : reached_by_check) EXPECT_GT(result.tally[p].cases, 0U) << info(p).name;
}

TEST(Check, CountsTheSameForAnyNumberOfThreads) {
  const Scene scene = shaded_floor_scene(30);
  const SceneView view(scene);
  // With something to find: the order of violations must not show either.
  const auto subject = mutant_named("intensity-of-representative")->subject();
  const CheckResult one = check(view, *subject, check_config(6'000, 1));
  EXPECT_GT(one.tally.violations(), 0U);
  for (const unsigned threads : {2U, 5U}) {
    const CheckResult many = check(view, *subject, check_config(6'000, threads));
    EXPECT_TRUE(one.tally == many.tally) << threads << " threads";
    EXPECT_EQ(one.rays, many.rays);
    EXPECT_EQ(one.undecided_rays, many.undecided_rays);
  }
}

/// The library with what it claims of its tree spoilt.
class NoTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] TreeClaim claim() const override {
    TreeClaim claim = LibraryTree::claim();
    claim.children.front() = 1000;
    return claim;
  }
};

TEST(Check, ConvictsWhatIsNoTreeAndAsksItNothingMore) {
  const Scene scene = floor_scene(10);
  const CheckResult result = check(SceneView(scene), subject_with<NoTree>(), check_config(1'000));
  EXPECT_THAT(violated(result.tally), ElementsAre(Property::tree_partitions_lights));
  EXPECT_EQ(result.points, 0U);
}

TEST(Check, VisitsAtLeastSoManyPairs) {
  const Scene scene = floor_scene(10);
  for (const std::uint64_t pairs : {1U, 19U, 20U, 1000U}) {
    const CheckResult result = check_library(scene, check_config(pairs));
    EXPECT_GE(result.pairs, pairs);
    EXPECT_LT(result.pairs, pairs + 19);
    EXPECT_EQ(result.pairs, result.points * 19);
    // Excerpts come on top.
    EXPECT_GE(result.tally[Property::bound_dominates_contribution].cases, result.pairs);
  }
}

TEST(Check, JudgesTwoCutsAtEachPointAndAnExactOneAtEveryEighth) {
  const CheckResult result = check_library(floor_scene(10), check_config(19U * 17));
  EXPECT_EQ(result.points, 17U);
  // None at the two beside lights; and three of the excerpt at the first one.
  EXPECT_EQ(result.tally[Property::cut_partitions_lights].cases, 2U * (17 - 2) + 3 + 3);
  EXPECT_EQ(result.tally[Property::zero_threshold_is_exact].cases, 3U + 1);
}

/// Where bounds are swept.
Scene diffuse_floor_scene(std::uint32_t lights) {
  Scene scene = floor_scene(lights);
  for (Surface& surface : scene.surfaces) surface.material.lobe = NoLobe{};
  return scene;
}

TEST(Check, SweepsBoundsOnDiffuseSurfacesUnderOmniLights) {
  const CheckResult swept = check_library(diffuse_floor_scene(100), check_config(199U * 320));
  EXPECT_EQ(swept.points, 320U);
  EXPECT_EQ(swept.swept_pairs, 199U * (320 - 320 / points_per_full_check));
  EXPECT_GE(swept.tally[Property::bound_dominates_contribution].cases, swept.pairs);
  EXPECT_GT(swept.tally[Property::bound_dominates_contribution].worst_ratio, 0.5);
  EXPECT_THAT(violated(swept.tally), IsEmpty());
  EXPECT_EQ(check_library(floor_scene(100), check_config(199U * 320)).swept_pairs, 0U);
}

/// Of one light, too low.
struct LowOfLeaves : LibraryTree {
  using LibraryTree::LibraryTree;
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    const glm::vec3 bound = LibraryTree::bound(node, point);
    return tree().node(node).is_leaf() ? 0.9F * bound : bound;
  }
};

TEST(Check, ConvictsALowBoundWhereBoundsAreSwept) {
  const Scene scene = diffuse_floor_scene(100);
  const CheckResult result =
      check(SceneView(scene), subject_with<LowOfLeaves>(), check_config(199U * 3200));
  const std::uint64_t full = 3200 / points_per_full_check;
  EXPECT_GT(result.tally[Property::bound_dominates_contribution].violations, 3 * full);
}

TEST(Check, BoundsBlocksOfNeighbouringPixels) {
  const Scene scene = shaded_floor_scene(40);
  const CheckResult result = check_library(scene, check_config(79U * 64));
  // At places 1 and 33 three points and more, each by all nodes; an excerpt's block is one point.
  EXPECT_GT(result.tally[Property::block_bound_dominates].cases, 2 * 3 * 79U);
  const auto subject = mutant_named("block-corner-forgotten")->subject();
  const Tally tally = check(SceneView(scene), *subject, check_config(79U * 640)).tally;
  EXPECT_THAT(violated(tally), ElementsAre(Property::block_bound_dominates));
}

TEST(Check, GoesOnAsIfItHadNotStopped) {
  for (const bool swept : {false, true}) {
    const Scene scene = swept ? diffuse_floor_scene(30) : shaded_floor_scene(30);
    const SceneView view(scene);
    const auto subject = library_subject();
    const CheckResult whole = check(view, *subject, check_config(59U * 600));
    CheckResult result;
    for (const std::uint64_t points : {1U, 70U, 600U}) {
      result = check(view, *subject, check_config(59 * points), result);
      EXPECT_EQ(result.points, points);
      EXPECT_TRUE(result.complete);
    }
    EXPECT_TRUE(whole.tally == result.tally);
    EXPECT_EQ(whole.rays, result.rays);
    EXPECT_EQ(whole.swept_pairs, result.swept_pairs);
  }
}

TEST(Check, EndsWhereItIsCancelledAndGoesOnFromThere) {
  const Scene scene = shaded_floor_scene(30);
  const SceneView view(scene);
  CheckConfig config = check_config(59U * 20'000);
  int asked = 0;
  config.progress = Progress::until([&asked] { return ++asked == 2; });
  const CheckResult part = check(view, *library_subject(), config);
  EXPECT_FALSE(part.complete);
  EXPECT_GT(part.points, 0U);
  EXPECT_LT(part.points, 20'000U);
  config.seconds = 1e-9;
  const CheckResult more = check(view, *library_subject(), config, part);
  EXPECT_FALSE(more.complete);
  EXPECT_GT(more.points, part.points);
}

/// The library, but takes every light for seen.
class BlindTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BlindTree>(shared_tree());
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>&) override {
    return LibraryTree::select(point, config, [](std::uint32_t) { return true; });
  }
};

TEST(Check, ConvictsASubjectThatIgnoresOcclusion) {
  for (const bool shaded : {false, true}) {
    const Scene scene = shaded ? shaded_floor_scene(30) : floor_scene(30);
    const SceneView view(scene);
    const Tally tally = check(view, subject_with<BlindTree>(), check_config(6'000)).tally;
    EXPECT_EQ(tally[Property::zero_threshold_is_exact].violations > 0, shaded);
  }
}

TEST(Check, ComparesTheRaysItCounts) {
  const CheckResult result = check_library(shaded_floor_scene(20), check_config(4'000));
  EXPECT_GE(result.rays, 1000U);
  EXPECT_EQ(result.rays - result.undecided_rays, result.tally[occlusion_checked].cases);
}

TEST(Check, DependsOnTheSeed) {
  const Scene scene = shaded_floor_scene(20);
  CheckConfig config = check_config(2'000);
  const CheckResult one = check_library(scene, config);
  EXPECT_TRUE(one.tally == check_library(scene, config).tally);
  config.seed = 2;
  EXPECT_FALSE(one.tally == check_library(scene, config).tally);
}

TEST(Check, ReportsProgressUpToTheEnd) {
  double last = 0;
  CheckConfig config = check_config(2'000, 1);
  config.progress = Progress([&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  (void)check_library(floor_scene(20), config);
  EXPECT_EQ(last, 1);
}

// The view keeps its own copy of the triangles, as they were: its answers miss the last square.
TEST(Check, ConvictsAnOccluderThatMissesTheLastTriangles) {
  Scene scene = shaded_floor_scene(30);
  const SceneView view(scene);
  ASSERT_TRUE(view.may_occlude());
  add_quad(scene, {-1.4F, 0.5F, 0.5F}, {-0.4F, 0.5F, 0.5F}, {-0.4F, 0.5F, -0.5F},
           {-1.4F, 0.5F, -0.5F});
  const CheckResult result = check(view, *library_subject(), check_config(6'000));
  EXPECT_THAT(violated(result.tally),
              ElementsAre(occlusion_checked, Property::proven_visibility_holds));
  EXPECT_THAT(result.tally[occlusion_checked].first_violation,
              testing::HasSubstr("seen, by brute force blocked"));
  EXPECT_THAT(result.tally[Property::proven_visibility_holds].first_violation,
              testing::HasSubstr("but blocked"));
}

TEST(Check, ConvictsAnOccluderThatHasTrianglesTooMany) {
  Scene scene = shaded_floor_scene(30);
  const SceneView view(scene);
  scene.mesh.triangles.resize(2);
  const CheckResult result = check(view, *library_subject(), check_config(6'000));
  EXPECT_THAT(violated(result.tally), ElementsAre(occlusion_checked));
  EXPECT_THAT(result.tally[occlusion_checked].first_violation,
              testing::HasSubstr("blocked, by brute force seen"));
}

// With threshold 0, but a black level, the cut is not exact.
TEST(Check, DoesNotAskForExactnessUnderABlackLevel) {
  CheckConfig config = check_config(6'000);
  config.cut = {0, 1000, 0.05F};
  EXPECT_THAT(violated(check_library(shaded_floor_scene(30), config).tally), IsEmpty());
}

TEST(Check, RefusesACameraThatSeesNothing) {
  Scene scene = floor_scene(3);
  scene.camera.target = {0, 6, 0.5F};
  scene.camera.up = {1, 0, 0};
  EXPECT_THROW((void)check_library(scene, check_config(100)), InputError);
}

TEST(Check, RefusesASceneWithoutLights) {
  EXPECT_THROW((void)check_library(floor_scene(0), check_config(100)), InputError);
}

} // namespace
} // namespace lightcuts::oracle
