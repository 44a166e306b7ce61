// SPDX-License-Identifier: MIT
#include <viz/model/picture/shading_settings.h>

#include <gtest/gtest.h>
#include <lightcuts/core/cut/stochastic_cut.h>

#include <tests/viz/support/counterexample_file.h>
#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

void expect_same(const Cut& a, const Cut& b) {
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.certified_error, b.certified_error);
  ASSERT_EQ(a.clusters.size(), b.clusters.size());
  for (std::size_t i = 0; i < a.clusters.size(); ++i) {
    EXPECT_EQ(a.clusters[i].node, b.clusters[i].node);
    EXPECT_EQ(a.clusters[i].estimate, b.clusters[i].estimate);
    EXPECT_EQ(a.clusters[i].bound, b.clusters[i].bound);
  }
}

constexpr CutConfig chosen_config{0.1F, 1000, 0};

void expect_tree_cuts_by(const ClusterRules& rules, Method method,
                         const ShadingSettings& settings = {}) {
  SCOPED_TRACE(method->name);
  const auto tree = tree_for(method, settings, *small_scene());
  CutSelector select(*small_scene()->tree(), chosen_config, rules);
  for (const glm::uvec2 pixel : some_pixels) {
    const SmallPoint at(pixel);
    expect_same(tree->select(at.p.point, chosen_config, at), select(at.p.point, at));
  }
}

TEST(TreeFor, CutsAsTheMethodDoes) {
  ShadingSettings settings;
  expect_tree_cuts_by(ClusterRules(), methods::lightcuts);
  expect_tree_cuts_by(ClusterRules(), methods::reference);
  expect_tree_cuts_by(ClusterRules(), methods::stochastic);
  expect_tree_cuts_by(methods::paper.rules, methods::paper);
  expect_tree_cuts_by(methods::unscaled.rules, methods::unscaled);
  expect_tree_cuts_by(methods::no_specular_bound.rules, methods::no_specular_bound);
}

TEST(TreeFor, HasTheChosenRulesForLightcutsAndNoOtherMethod) {
  ShadingSettings settings;
  settings.rules.bound = BoundRule::product;
  settings.rules.estimate = EstimateRule::representative;
  expect_tree_cuts_by(methods::paper.rules, methods::lightcuts, settings);
  expect_tree_cuts_by(methods::paper.rules, methods::reference, settings);
  expect_tree_cuts_by(methods::unscaled.rules, methods::unscaled, settings);
  expect_tree_cuts_by(methods::no_specular_bound.rules, methods::no_specular_bound, settings);
  expect_tree_cuts_by(ClusterRules(), methods::stochastic_intensity, settings);
}

template <class Importance>
void expect_tree_draws_by(Method method, std::uint64_t seed) {
  SCOPED_TRACE(method->name);
  ShadingSettings settings;
  settings.seed = seed;
  const auto first = tree_for(method, settings, *small_scene());
  const auto other = first->for_another_thread();
  const SmallPoint at({16, 12});
  for (oracle::SubjectTree* tree : {first.get(), other.get()})
    for (const std::uint64_t query : {0U, 400U, 77U}) {
      BasicStochasticCutSelector<Importance> select(*small_scene()->tree(), chosen_config, seed);
      expect_same(tree->draw(at.p.point, chosen_config, query, at), select(at.p.point, query, at));
    }
}

TEST(TreeFor, DrawsByTheSeedThatIsChosen) {
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    expect_tree_draws_by<HierarchicalImportance>(methods::stochastic, seed);
    expect_tree_draws_by<IntensityImportance>(methods::stochastic_intensity, seed);
  }
}

TEST(CutConfigOf, HasTheChosenThresholdOrTheScenesOwn) {
  const OpenedScene& scene = *small_scene();
  ShadingSettings settings;
  EXPECT_EQ(
      cut_config(settings, scene, scene.view()),
      (CutConfig{default_threshold(scene.view()), default_max_cut, scene.black_level(), false}));
  settings.threshold = 0.25F;
  settings.max_cut = 12;
  EXPECT_EQ(cut_config(settings, scene, scene.view()),
            (CutConfig{0.25F, 12, scene.black_level(), false}));
}

TEST(CutConfigOf, KnowsWhereNothingOccludes) {
  const auto open = opened("cloud?lights=20&blocks=0", {8, 6});
  ASSERT_FALSE(open->view().may_occlude());
  EXPECT_TRUE(cut_config({}, *open, open->view()).unoccluded);
}

TEST(CutConfigOf, IsThatOfACounterexample) {
  oracle::Counterexample c = counterexample_of(broken_bound);
  c.on.cut.threshold = 0.125F;
  c.on.cut.black_level = 0.5F;
  for (const bool unoccluded : {false, true}) {
    c.on.cut.unoccluded = unoccluded;
    const auto scene = CounterexampleFile(broken_bound, c).open();
    EXPECT_EQ(cut_config({}, *scene, scene->view()),
              (CutConfig{0.125F, default_max_cut, 0.5F, unoccluded}));
  }
}

} // namespace
} // namespace lightcuts::viz
