// SPDX-License-Identifier: MIT
#include <viz/model/workbench.h>

#include <chrono>
#include <thread>

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/subjects/process_clock.h>
#include <tests/viz/support/counterexample_file.h>
#include <tests/viz/support/settled_workbench.h>
#include <tests/viz/support/small_pictures.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Workbench, HasNothingBeforeSomethingIsAskedFor) {
  Workbench bench;
  settle(bench);
  EXPECT_EQ(bench.scene(), nullptr);
  EXPECT_EQ(bench.inspection(), nullptr);
  EXPECT_EQ(bench.current_picture(), nullptr);
  EXPECT_FALSE(bench.row(0));
  EXPECT_THAT(bench.messages(), IsEmpty());
}

TEST(Workbench, OpensTheSceneAndMakesItsPicture) {
  SmallWorkbench bench;
  settle(bench);
  ASSERT_NE(bench.scene(), nullptr);
  EXPECT_EQ(bench.scene()->request(), small_request());
  EXPECT_EQ(bench.camera(), bench.scene()->scene().camera);
  const auto frame = bench.sources(methods::lightcuts, layers::image).frame;
  EXPECT_TRUE(frame->complete());
  EXPECT_EQ(frame->rendering().radiance, made<Frame>(small_key())->rendering().radiance);
  EXPECT_EQ(bench.sources(methods::reference, layers::image).frame->share(), 0) << "not asked for";
}

TEST(Workbench, IsBusyUntilThatIsThere) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  ASSERT_TRUE(comes_true([&] {
    bench.update();
    return !bench.busy();
  }));
  ASSERT_NE(bench.scene(), nullptr);
  EXPECT_TRUE(bench.sources(methods::lightcuts, layers::image).frame->complete());
  EXPECT_TRUE(bench.inspection() && bench.inspection()->complete);
}

TEST(Workbench, MakesWhatTheLayerNeeds) {
  SmallWorkbench bench;
  bench.state.layer = layers::slack;
  settle(bench);
  LayerSources sources = bench.sources(methods::lightcuts, layers::slack);
  EXPECT_TRUE(sources.frame->complete() && sources.reference->complete());
  EXPECT_EQ(sources.truth, nullptr);
  bench.state.layer = layers::violations;
  settle(bench);
  sources = bench.sources(methods::lightcuts, layers::violations);
  EXPECT_TRUE(sources.truth->complete());
  EXPECT_THAT(sources.truth->violations(), testing::Each(0));
}

TEST(Workbench, MakesWhatBlocksShareOnlyForTheLayersOfThat) {
  SmallWorkbench bench;
  bench.state.display = methods::block_cuts;
  settle(bench);
  EXPECT_EQ(bench.sources(methods::block_cuts, layers::image).blocks, nullptr);
  EXPECT_EQ(bench.sources(methods::block_cuts, layers::block_size).blocks->share(), 0);
  bench.state.layer = layers::proven;
  settle(bench);
  const LayerSources sources = bench.sources(methods::block_cuts, layers::proven);
  EXPECT_TRUE(sources.blocks->complete());
  EXPECT_GT(statistics_of(layer_values(layers::proven, sources)).mean, 0.05);
}

TEST(Workbench, MakesBothSidesOfASplit) {
  SmallWorkbench bench;
  bench.state.split = true;
  bench.state.compared = methods::paper;
  settle(bench);
  EXPECT_TRUE(bench.sources(methods::lightcuts, layers::image).frame->complete());
  EXPECT_TRUE(bench.sources(methods::paper, layers::image).frame->complete());
}

TEST(Workbench, MakesTheReferenceWhileItIsWantedAndNothingWhileTheCameraMoves) {
  SmallWorkbench bench;
  bench.state.display = DisplayMethod::raster();
  bench.wants_reference = true;
  settle(bench);
  EXPECT_TRUE(bench.sources(methods::reference, layers::image).frame->complete());
  EXPECT_EQ(bench.sources(methods::lightcuts, layers::image).frame->share(), 0);
  bench.state.display = methods::lightcuts;
  bench.holds_pictures = true;
  settle(bench);
  EXPECT_EQ(bench.sources(methods::lightcuts, layers::image).frame->share(), 0);
  bench.holds_pictures = false;
  settle(bench);
  EXPECT_TRUE(bench.sources(methods::lightcuts, layers::image).frame->complete());
}

TEST(Workbench, MakesNoOtherPictureOfWhatDoesNotMatterToAMethod) {
  SmallWorkbench bench;
  settle(bench);
  const auto frame = [&](Method method) { return bench.sources(method, layers::image).frame; };
  const auto reference = frame(methods::reference), paper = frame(methods::paper);
  const auto cuts = frame(methods::lightcuts), drawn = frame(methods::stochastic);
  bench.state.shading.seed = 5;
  EXPECT_EQ(frame(methods::reference), reference);
  EXPECT_EQ(frame(methods::paper), paper);
  EXPECT_EQ(frame(methods::lightcuts), cuts);
  EXPECT_NE(frame(methods::stochastic), drawn);
  bench.state.shading.rules.bound = BoundRule::product;
  EXPECT_EQ(frame(methods::paper), paper);
  EXPECT_NE(frame(methods::lightcuts), cuts);
  bench.state.shading.threshold = 0.5F;
  EXPECT_EQ(frame(methods::reference), reference);
  EXPECT_NE(frame(methods::paper), paper);
  bench.state.camera = bench.camera();
  bench.state.camera->vertical_fov += 1;
  EXPECT_NE(frame(methods::reference), reference);
}

// ---- opening

TEST(WorkbenchOpening, LeavesTheLastGoodSceneWithAMessageWhereTheNextFails) {
  SmallWorkbench bench;
  settle(bench);
  const auto good = bench.scene();
  bench.open("nonsense");
  settle(bench);
  EXPECT_EQ(bench.scene(), good);
  EXPECT_EQ(bench.state.open, small_request());
  ASSERT_THAT(bench.messages(), SizeIs(1));
  EXPECT_THAT(bench.messages()[0].text, HasSubstr("nonsense"));
  EXPECT_TRUE(bench.messages()[0].error);
  bench.clear_messages();
  settle(bench);
  EXPECT_THAT(bench.messages(), IsEmpty()) << "it is not tried again and again";
}

TEST(WorkbenchOpening, SaysSoWhereTheFirstSceneFails) {
  Workbench bench;
  bench.open("nonsense");
  settle(bench);
  EXPECT_EQ(bench.scene(), nullptr);
  ASSERT_THAT(bench.messages(), SizeIs(1));
  bench.open(small_spec);
  bench.state.open.image_size = glm::uvec2(8, 6);
  settle(bench);
  EXPECT_NE(bench.scene(), nullptr);
}

TEST(WorkbenchOpening, CanBeCancelled) {
  SmallWorkbench bench;
  settle(bench);
  const auto good = bench.scene();
  bench.open("cloud?lights=1000000&blocks=0"); // 10 s to build its tree
  bench.update();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500)); // at the tree by now
  EXPECT_TRUE(bench.opening());
  bench.cancel_opening();
  // Its thread gives way to all others: on a busy machine, wall time says nothing.
  const double start = oracle::processor_seconds(getpid());
  ASSERT_TRUE(comes_true([&] { return !bench.opening(); }));
  EXPECT_LT(oracle::processor_seconds(getpid()) - start, 0.8);
  settle(bench);
  EXPECT_EQ(bench.scene(), good);
  EXPECT_EQ(bench.state.open, small_request());
  EXPECT_THAT(bench.messages(), IsEmpty());
}

TEST(WorkbenchOpening, OfTheFirstSceneCanBeCancelled) {
  Workbench bench;
  bench.open("cloud?lights=1000000&blocks=0");
  bench.update();
  bench.cancel_opening();
  settle(bench);
  EXPECT_EQ(bench.scene(), nullptr);
  bench.state.open = small_request();
  settle(bench);
  EXPECT_NE(bench.scene(), nullptr);
}

TEST(WorkbenchOpening, KeepsTheBuilder) {
  SmallWorkbench bench;
  bench.state.open.builder = Builder::locally_ordered;
  settle(bench);
  bench.open("cloud?lights=7&blocks=0");
  settle(bench);
  EXPECT_EQ(bench.scene()->request().builder, Builder::locally_ordered);
}

TEST(WorkbenchOpening, OpensWhatIsAskedForWhileAnotherFails) {
  SmallWorkbench bench;
  settle(bench);
  bench.open("nonsense");
  bench.update();
  ASSERT_TRUE(comes_true([&] { return !bench.opening(); }));
  SceneRequest other = small_request();
  other.spec = "cloud?lights=7&blocks=0";
  bench.state.open = other; // before the window has heard of the failure
  settle(bench);
  EXPECT_EQ(bench.scene()->request(), other);
  EXPECT_THAT(bench.messages(), SizeIs(1));
}

TEST(WorkbenchOpening, IsBusyUntilTheWindowHasWhatWasOpened) {
  SmallWorkbench bench;
  bench.update();
  ASSERT_TRUE(comes_true([&] { return !bench.opening(); }));
  EXPECT_TRUE(bench.busy());
  bench.open("nonsense");
  settle(bench);
  EXPECT_FALSE(bench.busy());
}

TEST(WorkbenchOpening, ForgetsTheSelection) {
  SmallWorkbench bench;
  bench.state.pixel = some_pixels[0];
  bench.state.node = 5;
  bench.state.step = 3;
  bench.state.image.fits = false;
  settle(bench);
  EXPECT_NE(bench.inspection(), nullptr);
  bench.state.camera = bench.camera();
  bench.open("cloud?lights=7&blocks=0");
  EXPECT_FALSE(bench.state.pixel || bench.state.node || bench.state.step || bench.state.camera);
  EXPECT_TRUE(bench.state.image.fits);
  bench.state.open.image_size = glm::uvec2(8, 6);
  settle(bench);
  EXPECT_EQ(bench.inspection(), nullptr);
  EXPECT_EQ(bench.scene()->scene().lights.size(), 7U);
}

TEST(WorkbenchOpening, DropsASelectionThatTheSceneDoesNotHave) {
  SmallWorkbench bench;
  bench.state.pixel = {32, 0};
  bench.state.node = 399;
  settle(bench);
  EXPECT_FALSE(bench.state.pixel);
  EXPECT_FALSE(bench.state.node);
}

TEST(WorkbenchOpening, SelectsWhereACounterexampleFails) {
  const oracle::Counterexample c = counterexample_of(broken_bound);
  const CounterexampleFile file(broken_bound, c);
  Workbench bench;
  bench.state.display = DisplayMethod::raster();
  bench.open(file.path());
  settle(bench);
  ASSERT_NE(bench.scene(), nullptr);
  EXPECT_EQ(bench.state.shading.threshold, c.on.cut.threshold);
  EXPECT_EQ(bench.state.shading.max_cut, c.on.cut.max_size);
  EXPECT_EQ(bench.state.node, 0U);
  EXPECT_TRUE(bench.state.pixel);
  ASSERT_TRUE(bench.selected_row());
  EXPECT_EQ(bench.selected_row()->bound, bench.scene()->counterexample()->bound);
}

TEST(WorkbenchOpening, KeepsASelectionInACounterexampleThatWasAskedForWithIt) {
  const CounterexampleFile file(broken_bound, counterexample_of(broken_bound));
  Workbench bench;
  bench.state.display = DisplayMethod::raster();
  bench.state.open.spec = file.path();
  bench.state.node = 1;
  bench.state.pixel = {3, 4};
  settle(bench);
  EXPECT_EQ(bench.state.node, 1U);
  EXPECT_EQ(bench.state.pixel, glm::uvec2(3, 4));
}

TEST(WorkbenchOpening, LeavesACounterexamplesThresholdBehind) {
  const CounterexampleFile file(broken_bound, counterexample_of(broken_bound));
  Workbench bench;
  bench.state.display = DisplayMethod::raster();
  bench.open(file.path());
  settle(bench);
  bench.open(small_spec);
  EXPECT_FALSE(bench.state.shading.threshold);
  EXPECT_EQ(bench.state.shading.max_cut, default_max_cut);
}

} // namespace
} // namespace lightcuts::viz
