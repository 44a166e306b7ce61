// SPDX-License-Identifier: MIT
#include <viz/model/workbench.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/viz/support/settled_workbench.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::IsEmpty;

TEST(WorkbenchInspection, IsThatOfTheSelectedPixel) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  settle(bench);
  ASSERT_NE(bench.inspection(), nullptr);
  const InspectionResult& result = *bench.inspection();
  const InspectionKey key{small_key(), some_pixels[0], {}};
  const Inspection expected = inspect(key);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.failure, "");
  EXPECT_EQ(result.key.pixel, some_pixels[0]);
  EXPECT_EQ(result.inspection.radiance, expected.radiance);
  EXPECT_EQ(result.inspection.clusters.size(), expected.clusters.size());
  EXPECT_TRUE(result.inspection.truth);
  EXPECT_TRUE(result.inspection.clairvoyant);
  EXPECT_EQ(result.curve.size.back(), expected.final_size);
}

TEST(WorkbenchInspection, FollowsTheStateAndEndsWithTheSelection) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  bench.state.step = 4;
  settle(bench);
  EXPECT_EQ(bench.inspection()->inspection.clusters.size(), 4U);
  bench.state.pixel = some_pixels[1];
  bench.state.step.reset();
  bench.state.shading.threshold = 0.3F;
  settle(bench);
  EXPECT_EQ(bench.inspection()->key.pixel, some_pixels[1]);
  EXPECT_EQ(bench.inspection()->inspection.config.threshold, 0.3F);
  bench.state.pixel.reset();
  settle(bench);
  EXPECT_EQ(bench.inspection(), nullptr);
}

TEST(WorkbenchInspection, OfTheReferenceIsWhatLightcutsWouldPick) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  bench.state.shading.threshold = 0.3F;
  bench.state.shading.max_cut = 77;
  bench.state.shading.rules.bound = BoundRule::product;
  settle(bench);
  const auto expected = bench.inspection();
  bench.state.display = methods::reference;
  settle(bench);
  EXPECT_EQ(bench.inspection()->inspection.config, expected->inspection.config);
  EXPECT_EQ(bench.inspection()->inspection.radiance, expected->inspection.radiance);
  EXPECT_EQ(bench.inspection()->inspection.final_size, expected->inspection.final_size);
}

TEST(WorkbenchInspection, HasARowOfEveryCluster) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  settle(bench);
  const InspectionKey key{small_key(), some_pixels[0], {}};
  for (std::uint32_t node = 0; node < bench.scene()->topology().size(); node += 7) {
    const auto row = bench.row(node), again = bench.row(node), expected = row_of(key, node);
    ASSERT_TRUE(row && again && expected);
    EXPECT_EQ(row->node, node);
    EXPECT_EQ(row->bound, expected->bound);
    EXPECT_EQ(row->estimate, expected->estimate);
    EXPECT_EQ(again->bound, row->bound);
  }
  EXPECT_FALSE(bench.row(399));
  EXPECT_FALSE(bench.selected_row());
  const ClusterRow& first = bench.inspection()->inspection.clusters.front();
  bench.state.node = first.node;
  EXPECT_EQ(bench.selected_row()->truth, first.truth) << "of the cut, with what is true";
  bench.state.pixel = some_pixels[1];
  settle(bench);
  EXPECT_EQ(bench.row(0)->bound, row_of({small_key(), some_pixels[1], {}}, 0)->bound);
}

oracle::MeasureConfig quick_report() {
  oracle::MeasureConfig config;
  config.thresholds = {0.1F};
  config.repeats = 1;
  return config;
}

TEST(WorkbenchReport, IsTheOraclesOfTheOpenScene) {
  SmallWorkbench bench;
  bench.start_report(quick_report());
  EXPECT_FALSE(bench.reporting()) << "there is no scene yet";
  settle(bench);
  bench.start_report(quick_report());
  EXPECT_TRUE(bench.reporting());
  settle(bench);
  ASSERT_TRUE(bench.report());
  EXPECT_EQ(bench.report()->scene, bench.scene());
  EXPECT_EQ(bench.report()->report.lights, 200U);
  EXPECT_EQ(bench.report()->report.runs.size(), 2U);
  EXPECT_EQ(bench.report_share(), 1);
  EXPECT_THAT(bench.messages(), IsEmpty());
}

TEST(WorkbenchReport, CanBeCancelled) {
  SmallWorkbench bench;
  settle(bench);
  oracle::MeasureConfig config = quick_report();
  config.repeats = 1'000'000;
  bench.start_report(config);
  ASSERT_TRUE(comes_true([&] { return bench.report_share() > 0; }));
  bench.cancel_report();
  settle(bench);
  EXPECT_FALSE(bench.reporting());
  EXPECT_FALSE(bench.report());
  EXPECT_THAT(bench.messages(), IsEmpty());
}

TEST(WorkbenchReport, ThatFailsSaysWhy) {
  SmallWorkbench bench;
  settle(bench);
  oracle::MeasureConfig config = quick_report();
  config.thresholds = {-1};
  bench.start_report(config);
  settle(bench);
  EXPECT_FALSE(bench.report());
  ASSERT_THAT(bench.messages(), testing::SizeIs(1));
  EXPECT_THAT(bench.messages()[0].text, testing::StartsWith("report: "));
  EXPECT_TRUE(bench.messages()[0].error);
}

} // namespace
} // namespace lightcuts::viz
