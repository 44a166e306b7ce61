// SPDX-License-Identifier: MIT
#include <oracle/report/measure.h>

#include <atomic>
#include <cmath>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/builtin/builtin_scenes.h>

#include <tests/oracle/support/small_scene.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MeasureConfig quick() {
  MeasureConfig config;
  config.thresholds = {0.02F, 0.5F};
  config.threads = 2;
  config.repeats = 1;
  return config;
}

Measurement measured(const Scene& scene, const MeasureConfig& config = quick()) {
  return measure(SceneView(scene), config);
}

std::vector<std::pair<std::string, float>> rows_of(const Report& report) {
  std::vector<std::pair<std::string, float>> rows;
  for (const oracle::Run& run : report.runs) rows.emplace_back(run.method, float(run.threshold));
  return rows;
}

/// So many lights that the tree pays at a loose threshold.
Scene many_lights() { return floor_scene(4000); }

TEST(Measure, HasTheRowsAskedFor) {
  const Scene scene = floor_scene(20);
  EXPECT_THAT(rows_of(measured(scene).report),
              ElementsAre(std::pair("reference", 0), std::pair("lightcuts", 0.02F),
                          std::pair("lightcuts", 0.5F)));
  MeasureConfig config = quick();
  config.methods = {methods::lightcuts};
  config.thresholds = {0.1F};
  EXPECT_THAT(rows_of(measured(scene, config).report), ElementsAre(std::pair("lightcuts", 0.1F)));
  config.methods = {methods::reference};
  EXPECT_THAT(rows_of(measured(scene, config).report), ElementsAre(std::pair("reference", 0)));
}

TEST(Measure, BuildsTheTreeAsAsked) {
  MeasureConfig config = quick();
  config.methods = {methods::lightcuts};
  config.thresholds = {0.5F};
  const Scene scene = many_lights();
  const auto cut_size = [&](Builder builder) {
    config.builder = builder;
    const Report report = measured(scene, config).report;
    EXPECT_EQ(report.builder, name_of(builder));
    return report.runs.front().mean_cut_size;
  };
  EXPECT_NE(cut_size(Builder::greedy), cut_size(Builder::locally_ordered));
}

TEST(Measure, MeasuresEveryMethod) {
  MeasureConfig config = quick();
  config.methods.assign(std::begin(all_methods), std::end(all_methods));
  config.thresholds = {0.5F};
  const Report report = measured(many_lights(), config).report;
  ASSERT_EQ(report.runs.size(), std::size(all_methods));
  for (const oracle::Run& run : report.runs) {
    EXPECT_TRUE(std::isfinite(run.mean_certified_error)) << run.method;
    EXPECT_GE(run.mean_certified_error, run.mean_relative_error) << run.method;
    // What is drawn has no clairvoyant cut.
    EXPECT_EQ(run.optimal_cut_size > 0,
              run.method != "reference" && !(*method_named(run.method))->draws)
        << run.method;
  }
}

TEST(Measure, DrawsByTheSeed) {
  MeasureConfig config = quick();
  config.methods = {methods::stochastic};
  const auto error = [&](std::uint64_t seed) {
    config.seed = seed;
    return measured(many_lights(), config).report.runs.front().rel_rmse;
  };
  EXPECT_EQ(error(1), error(1));
  EXPECT_NE(error(1), error(2));
}

TEST(Measure, SaysWhatWasMeasured) {
  const Scene scene = floor_scene(20);
  MeasureConfig config = quick();
  config.seed = 7;
  config.repeats = 3;
  const Report report = measured(scene, config).report;
  EXPECT_EQ(report.scene, "floor");
  EXPECT_EQ(report.seed, 7U);
  EXPECT_EQ(report.lights, 20U);
  EXPECT_EQ(report.triangles, 2U);
  EXPECT_EQ(report.size, glm::uvec2(16, 12));
  EXPECT_EQ(report.surface_pixels, 192U);
  EXPECT_EQ(report.threads, 2U);
  EXPECT_EQ(report.repeats, 3);
  EXPECT_GT(report.black_level, 0);
  EXPECT_EQ(report.cut_sizes.size(), 192U);
}

TEST(Measure, FindsTheReferenceWithoutError) {
  const oracle::Run run = measured(floor_scene(20)).report.runs.front();
  EXPECT_EQ(run.rel_rmse, 0);
  EXPECT_EQ(run.max_relative_error, 0);
  EXPECT_EQ(run.speedup_over_reference, 1);
  EXPECT_EQ(run.mean_cut_size, 20);
  EXPECT_EQ(run.build_seconds, 0);
  EXPECT_EQ(run.efficiency, 0);
  EXPECT_GT(run.render_seconds, 0);
}

TEST(Measure, TakesTheReferenceWhereTheTreeIsLeftOut) {
  const Measurement m = measured(floor_scene(20));
  EXPECT_FALSE(m.features.tree);
  const oracle::Run& reference = m.report.runs[0];
  const oracle::Run& run = m.report.runs[1];
  EXPECT_EQ(run.render_seconds, reference.render_seconds);
  EXPECT_EQ(run.speedup_over_reference, 1);
  EXPECT_EQ(run.rel_rmse, 0);
  EXPECT_EQ(run.build_seconds, 0);
  EXPECT_EQ(run.mean_cut_size, 20);
  EXPECT_EQ(m.shown.radiance, m.reference.radiance);
}

TEST(Measure, UsesTheTreeForManyLights) {
  const Measurement m = measured(many_lights());
  const oracle::Run& run = m.report.runs.back();
  EXPECT_GT(run.build_seconds, 0);
  EXPECT_LT(run.mean_cut_size, 1000);
  EXPECT_GT(run.rel_rmse, 0);
  EXPECT_GE(run.max_relative_error, run.mean_relative_error);
  EXPECT_GE(run.mean_certified_error, run.mean_relative_error);
  EXPECT_NEAR(run.efficiency, 1 / (run.rel_rmse * run.rel_rmse * run.render_seconds),
              1e-9 * run.efficiency);
}

TEST(Measure, FindsCutsNoSmallerThanTheClairvoyantOnes) {
  for (const oracle::Run& run : measured(many_lights()).report.runs)
    if (run.method == "lightcuts") {
      EXPECT_GE(run.optimal_cut_size, 1);
      EXPECT_GT(run.cut_efficiency, 0);
      EXPECT_LE(run.cut_efficiency, 1);
    }
}

TEST(Measure, ShowsThePictureAtTheThresholdNearestToTheScenesOwn) {
  MeasureConfig config = quick();
  config.thresholds = {0.5F, 0.03F, 0.2F};
  EXPECT_EQ(measured(floor_scene(20), config).shown_threshold, 0.2F); // open and glossy: 16 %
}

TEST(Measure, ReportsProgressUpToTheEnd) {
  double last = 0;
  MeasureConfig config = quick();
  config.threads = 1;
  config.progress = Progress([&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  (void)measured(many_lights(), config);
  EXPECT_NEAR(last, 1, 1e-12);
}

TEST(Measure, GivesTheSameErrorsEachTime) {
  const Scene scene = many_lights();
  const Report a = measured(scene).report, b = measured(scene).report;
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    EXPECT_EQ(a.runs[i].rel_rmse, b.runs[i].rel_rmse);
    EXPECT_EQ(a.runs[i].mean_cut_size, b.runs[i].mean_cut_size);
    EXPECT_EQ(a.runs[i].optimal_cut_size, b.runs[i].optimal_cut_size);
  }
}

TEST(Measure, EndsWhereItIsCancelled) {
  MeasureConfig config = quick();
  config.progress = Progress::until([] { return true; });
  EXPECT_THROW((void)measured(many_lights(), config), Cancelled);
  // In the middle, too, without going on to the rows that are left.
  std::atomic<double> share = 0;
  config.repeats = 1'000'000;
  config.progress = Progress([&](double done) { share = done; }, [&] { return share > 0; });
  EXPECT_THROW((void)measured(floor_scene(20), config), Cancelled);
  EXPECT_LT(share, 0.01);
}

TEST(Measure, IsTheSameWhereItCouldHaveBeenCancelled) {
  const Scene scene = floor_scene(20);
  MeasureConfig config = quick();
  config.progress = Progress::until([] { return false; });
  EXPECT_EQ(measured(scene, config).reference.radiance, measured(scene).reference.radiance);
}

TEST(Measure, RefusesASceneWithoutLightsAndACameraThatSeesNothing) {
  EXPECT_THROW((void)measured(floor_scene(0)), InputError);
  Scene away = floor_scene(3);
  away.camera.target = {0, 6, 0.5F};
  away.camera.up = {1, 0, 0};
  EXPECT_THROW((void)measured(away), InputError);
}

TEST(DescribeNeeds, SaysSoWhereTheCameraSeesNoSurface) {
  const Scene scene = floor_scene(20);
  const SceneView view(scene);
  std::vector<std::string> needed, left_out;
  describe_features(view, SceneFeatures{}, 0.02F, needed, left_out);
  EXPECT_THAT(left_out, testing::Contains(HasSubstr("sees no surface")));
}

TEST(DescribeNeeds, SaysWhatIsNeededAndWhatIsLeftOut) {
  const Scene scene = floor_scene(20);
  const SceneView view(scene);
  SceneFeatures features;
  features.sees_surface = true;
  features.kinds = only(LightKind::omni) | only(LightKind::spot);
  features.pilot_cut_size = 12.5;
  features.pilot_cost_of_cuts = 3;
  features.pilot_cost_of_sums = 2;
  std::vector<std::string> needed, left_out;
  describe_features(view, features, 0.02F, needed, left_out);
  EXPECT_THAT(needed, ElementsAre("omni, spot lights"));
  EXPECT_THAT(left_out,
              ElementsAre("oriented, directional, profile lights: there are none",
                          HasSubstr("clamp"), HasSubstr("specular bound"), HasSubstr("shadow rays"),
                          testing::AllOf(HasSubstr("light tree"), HasSubstr("2 %"),
                                         HasSubstr("12.5 of 20 lights"), HasSubstr("1.50 times"))));
  features.specular = features.occlusion = features.tree = features.clamp = true;
  features.kinds = all_light_kinds;
  needed.clear();
  left_out.clear();
  describe_features(view, features, 0.02F, needed, left_out);
  EXPECT_EQ(needed.size(), 5U);
  EXPECT_TRUE(left_out.empty());
}

/// Mean relative error of lightcuts at the scene's own threshold.
double mean_error_at_default(const std::string& spec) {
  Scene scene = make_builtin(spec);
  scene.image_size = {40, 30};
  const SceneView view(scene);
  MeasureConfig config;
  config.thresholds = {default_threshold(view)};
  config.repeats = 1;
  const Measurement m = measure(view, config);
  return m.report.runs.back().mean_relative_error;
}

TEST(DefaultThreshold, MakesAMeanErrorOfAtMostOnePercent) {
  for (const char* parameters : {"", "&material=phong", "&material=ggx", "&kind=directional",
                                 "&kind=oriented", "&kind=spot", "&kind=mixed"})
    for (const char* blocks : {"&blocks=0", "&blocks=40"}) {
      const std::string spec = std::string("cloud?lights=5000") + blocks + parameters;
      const double error = mean_error_at_default(spec);
      std::cout << spec << ": " << 100 * error << " %\n";
      EXPECT_LE(error, 0.01) << spec;
    }
}

// Its cuts are so deep that a small cap ends them at a large error.
TEST(DefaultMaxCut, DoesNotEndCutsThatTheThresholdWouldNot) {
  EXPECT_LE(mean_error_at_default("cloud?lights=20000&kind=spot"), 0.01);
}

} // namespace
} // namespace lightcuts::oracle
