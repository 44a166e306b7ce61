// SPDX-License-Identifier: MIT
#include <viz/model/scene/opened_scene.h>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/view/scene_features.h>
#include <oracle/cases/random_case.h>
#include <oracle/truth/truth.h>

#include <tests/render/support/refusal.h>
#include <tests/viz/support/counterexample_file.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::shared_ptr<const OpenedScene> open(const SceneRequest& request) {
  return std::make_shared<const OpenedScene>(request);
}

TEST(OpenedScene, HasTheSceneItsTreeAndWhatTheyNeed) {
  const OpenedScene& scene = *small_scene();
  EXPECT_EQ(scene.scene().lights.size(), 200U);
  EXPECT_EQ(scene.scene().image_size, glm::uvec2(32, 24));
  EXPECT_EQ(scene.view().size(), glm::uvec2(32, 24));
  EXPECT_EQ(scene.tree()->lights().size(), 200U);
  EXPECT_EQ(scene.topology().size(), 399U);
  EXPECT_EQ(scene.default_threshold(), default_threshold(scene.view()));
  const CutConfig config{scene.default_threshold(), default_max_cut, 0};
  EXPECT_EQ(scene.black_level(),
            find_scene_features(scene.view(), *scene.tree(), config).black_level);
  EXPECT_GT(scene.black_level(), 0);
  EXPECT_GE(scene.build_seconds(), 0);
  EXPECT_FALSE(scene.counterexample());
}

TEST(OpenedScene, KnowsHowDeepEveryNodeLies) {
  const OpenedScene& scene = *small_scene();
  std::vector<int> parent(scene.topology().size(), -1);
  for (std::uint32_t node = 0; node < parent.size(); ++node)
    for (const std::uint32_t child : scene.topology().children(node)) parent[child] = int(node);
  for (std::uint32_t node = 0; node < parent.size(); ++node) {
    std::uint32_t depth = 0;
    for (int above = parent[node]; above >= 0; above = parent[std::size_t(above)]) ++depth;
    EXPECT_EQ(scene.depth(node), depth) << node;
  }
}

TEST(OpenedScene, ChoosesRepresentativesByTheSeed) {
  const auto representatives = [](std::uint64_t seed) {
    SceneRequest request = small_request();
    request.tree_seed = seed;
    const auto scene = open(request);
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < scene->topology().size(); ++i)
      all.push_back(scene->topology().representative(i));
    return all;
  };
  EXPECT_EQ(representatives(1), representatives(1));
  EXPECT_NE(representatives(1), representatives(2));
}

TEST(OpenedScene, BuildsTheTreeAsAsked) {
  SceneRequest request = small_request();
  for (const Builder builder : all_builders) {
    request.builder = builder;
    const auto scene = open(request);
    const LightTree tree = build(scene->scene().lights, {1, builder});
    for (std::uint32_t i = 0; i < tree.nodes().size(); ++i)
      ASSERT_EQ(scene->tree()->node(i).box, tree.node(i).box) << name_of(builder) << ", node " << i;
  }
}

TEST(OpenedScene, ClampsDistancesAsAsked) {
  EXPECT_EQ(small_scene()->scene().lights.min_distance(), 0);
  SceneRequest request = small_request();
  request.min_distance = 0.25F;
  EXPECT_EQ(open(request)->scene().lights.min_distance(), 0.25F);
}

TEST(OpenedScene, PutsRandomLightsInPlaceOfItsOwn) {
  SceneRequest request{.spec = "cloud?lights=5&blocks=3&clamp=0.5", .lights = 77};
  request.image_size = glm::uvec2(8, 6);
  const auto scene = open(request);
  EXPECT_EQ(scene->scene().lights.size(), 77U);
  EXPECT_EQ(scene->scene().lights.min_distance(), 0.5F) << "as the scene has it";
}

TEST(OpenedScene, LightsADarkModelAndSaysSo) {
  const TemporaryFolder folder;
  const auto file = folder.path / "dark.obj";
  write(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\n");
  const auto scene = open({.spec = file.string(), .image_size = glm::uvec2(8, 6)});
  EXPECT_EQ(scene->scene().lights.size(), lights_for_dark_scenes);
  EXPECT_THAT(scene->scene().notes, Contains(HasSubstr("no lights")));
}

TEST(OpenedScene, RefusesWhatCannotBeOpenedWithItsName) {
  const TemporaryFolder folder;
  expect_refusal("nonsense", [] { (void)open({.spec = "nonsense"}); });
  expect_refusal("none.obj", [] { (void)open({.spec = "none.obj"}); });
  const std::string file = (folder.path / "some.json").string();
  write(file, R"({"schema": 3})");
  expect_refusal("some.json", [&] { (void)open({.spec = file}); });
  write(file, R"({"schema": "lightcuts-oracle/counterexample/1"})");
  expect_refusal("some.json", [&] { (void)open({.spec = file}); });
  SceneRequest request = small_request();
  request.min_distance = -1;
  EXPECT_THROW((void)open(request), InputError);
  request = small_request();
  request.image_size = glm::uvec2(0, 3);
  EXPECT_THROW((void)open(request), InputError);
}

TEST(OpenedCounterexample, SaysWhatFailsAndWhere) {
  const oracle::Counterexample c = counterexample_of(broken_bound);
  const auto scene = CounterexampleFile(broken_bound, c).open();
  ASSERT_TRUE(scene->counterexample());
  const OpenedCounterexample& opened = *scene->counterexample();
  EXPECT_EQ(opened.saved.subject, broken_bound);
  EXPECT_EQ(opened.saved.counterexample.on, c.on);
  EXPECT_TRUE(opened.still_fails);
  EXPECT_EQ(opened.message, c.message);
  EXPECT_NE(opened.explanation, "");
  EXPECT_EQ(opened.view, 0U);
  EXPECT_EQ(opened.node, 0U) << "of two lights the only cluster that is no light";
  EXPECT_EQ(scene->scene().name, "found");
  EXPECT_EQ(scene->default_threshold(), c.on.cut.threshold);
  EXPECT_EQ(scene->black_level(), c.on.cut.black_level);
}

TEST(OpenedCounterexample, HasWhatTheSubjectSaysAndWhatIsTrue) {
  oracle::Counterexample c = counterexample_of(broken_bound);
  ASSERT_EQ(c.property, oracle::Property::bound_dominates_contribution);
  const auto scene = CounterexampleFile(broken_bound, c).open();
  const OpenedCounterexample& opened = *scene->counterexample();
  glm::dvec3 open_sum(0), seen_sum(0);
  const oracle::CaseView& view = c.on.views[0];
  for (std::uint32_t i = 0; i < c.on.lights.size(); ++i) {
    const oracle::Wide w =
        oracle::contribution(c.on.lights[i], view.view.point(), c.on.min_distance);
    const glm::dvec3 one{double(w[0]), double(w[1]), double(w[2])};
    open_sum += one;
    if (std::find(view.hidden.begin(), view.hidden.end(), i) == view.hidden.end()) seen_sum += one;
  }
  bool broken = false;
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(opened.open_truth[i], open_sum[i]);
    EXPECT_DOUBLE_EQ(opened.seen_truth[i], seen_sum[i]);
    broken = broken || double(opened.bound[i]) < open_sum[i];
  }
  EXPECT_TRUE(broken);
  const auto tree = scene->subject_tree();
  EXPECT_EQ(tree->bound(0, view.view.point()), opened.bound);
}

TEST(OpenedCounterexample, OfACutHasNoCluster) {
  const auto scene = CounterexampleFile(broken_cut, counterexample_of(broken_cut)).open();
  EXPECT_TRUE(scene->counterexample()->still_fails);
  EXPECT_FALSE(scene->counterexample()->node);
}

TEST(OpenedCounterexample, HoldsForTheLibrary) {
  const auto scene = CounterexampleFile("lightcuts", counterexample_of(broken_bound)).open();
  EXPECT_FALSE(scene->counterexample()->still_fails);
  EXPECT_EQ(scene->counterexample()->message, "");
  EXPECT_FALSE(scene->counterexample()->node);
}

TEST(OpenedCounterexample, HasTheTreeOfItsSubjectsBuilder) {
  oracle::Counterexample c{oracle::Property::bound_dominates_contribution, {}, "", 0};
  for (int i = 0; i < 20; ++i)
    c.on.lights.push_back(
        {.position = {i * i % 7, i * i % 11, 1 + i % 3}, .intensity = glm::vec3(1)});
  c.on.views.push_back({});
  const CounterexampleFile file("locally-ordered", c);
  const auto scene = file.open();
  const LightTree tree = build(scene->scene().lights, {c.on.seed, Builder::locally_ordered});
  const LightTree greedy = build(scene->scene().lights, {c.on.seed});
  bool differ = false;
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    ASSERT_EQ(scene->tree()->node(i).box, tree.node(i).box) << i;
    ASSERT_EQ(scene->topology().light_count(i), tree.node(i).light_count) << i;
    differ = differ || greedy.node(i).box != tree.node(i).box;
  }
  EXPECT_TRUE(differ);
}

TEST(OpenedCounterexample, OpensWhateverTheCase) {
  for (std::uint64_t index = 0; index < 300; ++index) {
    const oracle::Counterexample c{oracle::Property::bound_dominates_contribution,
                                   oracle::random_case(3, index), "", index};
    EXPECT_NO_THROW((void)CounterexampleFile("lightcuts", c).open()) << "case " << index;
  }
}

TEST(OpenedCounterexample, IsRefusedWhereThereIsNothingToLookAt) {
  const oracle::Counterexample c = counterexample_of(broken_bound);
  expect_refusal("unheard-of", [&] { (void)CounterexampleFile("unheard-of", c).open(); });
  oracle::Counterexample pointless = c, dark = c;
  pointless.on.views.clear();
  expect_refusal("no shading point",
                 [&] { (void)CounterexampleFile(broken_bound, pointless).open(); });
  dark.on.lights.clear();
  for (oracle::CaseView& view : dark.on.views) view.hidden.clear();
  expect_refusal("no light", [&] { (void)CounterexampleFile(broken_bound, dark).open(); });
}

} // namespace
} // namespace lightcuts::viz
