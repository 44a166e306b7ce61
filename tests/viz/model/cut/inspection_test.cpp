// SPDX-License-Identifier: MIT
#include <viz/model/cut/inspection.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/cut/stochastic_cut.h>
#include <oracle/properties/cut_answer.h>
#include <oracle/properties/judge.h>

#include <tests/viz/support/counterexample_file.h>
#include <tests/viz/support/small_pictures.h>
#include <viz/model/picture/lit_square.h>

namespace lightcuts::viz {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

CutConfig config_of(const ShadingSettings& settings) {
  return {*settings.threshold, settings.max_cut, small_scene()->black_level(), false};
}

void expect_cut(const Inspection& found, const Cut& cut) {
  EXPECT_EQ(found.radiance, cut.radiance);
  EXPECT_EQ(found.certified_error, cut.certified_error);
  EXPECT_EQ(found.shadow_rays, cut.shadow_rays);
  EXPECT_EQ(found.end, cut.end);
  ASSERT_EQ(found.clusters.size(), cut.clusters.size());
  for (std::size_t i = 0; i < cut.clusters.size(); ++i) {
    EXPECT_EQ(found.clusters[i].node, cut.clusters[i].node);
    EXPECT_EQ(found.clusters[i].estimate, cut.clusters[i].estimate);
    EXPECT_EQ(found.clusters[i].bound, cut.clusters[i].bound);
    EXPECT_EQ(found.clusters[i].visible, cut.clusters[i].visible);
  }
}

void expect_cuts_by(const ClusterRules& rules, Method method) {
  SCOPED_TRACE(method->name);
  CutSelector select(*small_scene()->tree(), config_of(always_cuts()), rules);
  for (const glm::uvec2 pixel : some_pixels) {
    const SmallPoint at(pixel);
    const Inspection found = inspect({small_key(method), pixel, {}});
    expect_cut(found, select(at.p.point, at));
    EXPECT_EQ(found.final_size, found.clusters.size());
    EXPECT_EQ(found.config, config_of(always_cuts()));
    EXPECT_FALSE(found.refined_next);
  }
}

TEST(Inspect, PicksTheCutOfTheMethod) {
  expect_cuts_by(ClusterRules(), methods::lightcuts);
  expect_cuts_by(ClusterRules(), methods::reference);
  expect_cuts_by(methods::paper.rules, methods::paper);
  expect_cuts_by(methods::unscaled.rules, methods::unscaled);
  expect_cuts_by(methods::no_specular_bound.rules, methods::no_specular_bound);
}

template <class Importance>
void expect_draws_by(Method method, std::uint64_t seed) {
  SCOPED_TRACE(method->name);
  ShadingSettings settings = always_cuts();
  settings.seed = seed;
  BasicStochasticCutSelector<Importance> select(*small_scene()->tree(), config_of(settings), seed);
  for (const glm::uvec2 pixel : some_pixels) {
    const SmallPoint at(pixel);
    expect_cut(inspect({small_key(method, settings), pixel, {}}),
               select(at.p.point, std::uint64_t(pixel.y) * 32 + pixel.x, at));
  }
}

TEST(Inspect, DrawsThePixelsOwnLights) {
  for (const std::uint64_t seed : {1U, 9U}) {
    expect_draws_by<HierarchicalImportance>(methods::stochastic, seed);
    expect_draws_by<IntensityImportance>(methods::stochastic_intensity, seed);
  }
}

TEST(Inspect, HasTheRadianceOfTheRenderedPixelByEveryMethodWithACut) {
  ShadingSettings settings = always_cuts();
  settings.seed = 3;
  for (const Method method : all_methods) {
    if (method == methods::reference) continue;
    const auto frame = made<Frame>(small_key(method, settings));
    for (const glm::uvec2 pixel : some_pixels) {
      const Inspection found = inspect({frame->key(), pixel, {}});
      const std::size_t i = std::size_t(pixel.y) * 32 + pixel.x;
      EXPECT_EQ(found.radiance, frame->rendering().radiance[i]) << method->name;
      EXPECT_EQ(float(found.final_size), frame->rendering().cut_size[i]) << method->name;
      EXPECT_EQ(float(found.shadow_rays), frame->rendering().shadow_rays[i]) << method->name;
      EXPECT_EQ(found.emission, frame->rendering().emission[i]);
    }
  }
}

TEST(Inspect, SaysHowTheVisibilityOfClustersOfASharedCutWasFound) {
  const FrameKey key = small_key(methods::block_cuts);
  const CutConfig config = Frame(key).cut();
  for (const glm::uvec2 pixel : some_pixels) {
    const Inspection found = inspect({key, pixel, {}});
    const LitSquare lit(key.scene->view(), *key.scene->tree(), config, 1, pixel);
    const auto sights = lit.sights(lit.index_of(pixel));
    ASSERT_EQ(found.clusters.size(), sights.size());
    for (std::size_t i = 0; i < sights.size(); ++i) EXPECT_EQ(found.clusters[i].sight, sights[i]);
    const auto& block = lit.block(lit.index_of(pixel));
    ASSERT_EQ(found.block.size(), block.size());
    for (std::size_t i = 0; i < block.size(); ++i)
      EXPECT_EQ(found.block[i], lit.pixels()[block[i]]);
    EXPECT_EQ(std::ranges::count(found.block, pixel), 1);
  }
}

TEST(Inspect, HasRaysAloneWhereEachPixelIsLitAlone) {
  const Inspection found = inspect({small_key(), some_pixels[0], {}});
  EXPECT_THAT(found.block, IsEmpty());
  for (const ClusterRow& row : found.clusters) {
    const bool matters = row.estimate != glm::dvec3(0) || !row.visible;
    EXPECT_EQ(row.sight, matters ? std::optional(Sight::ray) : std::nullopt);
  }
}

TEST(Inspect, DescribesThePoint) {
  const SmallPoint at(some_pixels[0]);
  const Inspection found = inspect({small_key(), some_pixels[0], {}});
  EXPECT_TRUE(found.sees_surface);
  EXPECT_EQ(found.position, at.p.point.position());
  EXPECT_EQ(found.normal, at.p.point.normal());
  EXPECT_EQ(found.to_viewer, at.p.point.to_viewer());
  EXPECT_EQ(found.material.diffuse, at.p.point.material().diffuse);
  EXPECT_FALSE(found.truth);
}

TEST(Inspect, DescribesEveryClusterByItsLights) {
  const Inspection found = inspect({small_key(), some_pixels[0], {}});
  const oracle::Topology& topology = small_scene()->topology();
  const LightSet& lights = small_scene()->scene().lights;
  std::vector<int> times(lights.size(), 0);
  for (const ClusterRow& row : found.clusters) {
    const auto below = topology.all_lights(row.node);
    glm::dvec3 intensity(0);
    for (const std::uint32_t light : below) {
      ++times[light];
      intensity += glm::dvec3(lights[light].intensity);
      EXPECT_TRUE(row.box.contains(lights[light].position));
    }
    EXPECT_EQ(row.lights, below.size());
    EXPECT_NEAR(row.intensity.x / intensity.x, 1, 1e-6);
    EXPECT_THAT(below, testing::Contains(row.representative));
    EXPECT_EQ(row.representative_position, lights[row.representative].position);
    EXPECT_EQ(row.depth, small_scene()->depth(row.node));
    EXPECT_TRUE(row.has_box);
  }
  EXPECT_THAT(times, testing::Each(1)) << "a cut is a partition of the lights";
}

TEST(Inspect, MeasuresTheDistanceToTheNearestPointOfTheBox) {
  const Inspection found = inspect({small_key(), some_pixels[0], {}});
  for (const ClusterRow& row : found.clusters) {
    double squares = 0;
    for (int c = 0; c < 3; ++c) {
      const double below = double(row.box.lo[c]) - found.position[c];
      const double above = found.position[c] - double(row.box.hi[c]);
      squares += std::pow(std::max({0.0, below, above}), 2);
    }
    EXPECT_NEAR(row.distance, std::sqrt(squares), 1e-6);
  }
}

TEST(Inspect, SharesOutWhatTheThresholdAllows) {
  const Inspection found = inspect({small_key(), some_pixels[0], {}});
  glm::dvec3 total(0);
  for (const ClusterRow& row : found.clusters) total += row.estimate;
  for (const ClusterRow& row : found.clusters) {
    double share = 0;
    for (int c = 0; c < 3; ++c)
      share = std::max(share, row.bound[c] /
                                  std::max(0.1 * total[c], double(small_scene()->black_level())));
    EXPECT_NEAR(row.share, share, 1e-6);
    EXPECT_LE(row.share, 1 + 1e-6) << "the cut has converged";
  }
}

TEST(Inspect, OfAStepIsTheCutOfThatSize) {
  for (const Method method : std::initializer_list<Method>{methods::lightcuts, methods::paper}) {
    const Inspection final = inspect({small_key(method), some_pixels[0], {}});
    ASSERT_GT(final.final_size, 8U);
    ASSERT_LT(final.final_size, 200U);
    for (const std::uint32_t step : {1U, 2U, 7U, final.final_size - 1}) {
      ShadingSettings small = always_cuts();
      small.max_cut = step;
      const Inspection expected = inspect({small_key(method, small), some_pixels[0], {}});
      const Inspection found = inspect({small_key(method), some_pixels[0], step});
      EXPECT_THAT(found.clusters, SizeIs(step));
      EXPECT_EQ(found.radiance, expected.radiance);
      EXPECT_EQ(found.certified_error, expected.certified_error);
      EXPECT_EQ(found.final_size, final.final_size);
      EXPECT_EQ(found.config, final.config);
    }
    const std::uint32_t beyond = final.final_size + 50;
    EXPECT_EQ(inspect({small_key(method), some_pixels[0], beyond}).radiance, final.radiance);
  }
}

TEST(Inspect, NamesTheClusterThatTheNextStepReplaces) {
  const oracle::Topology& topology = small_scene()->topology();
  const InspectionKey key{small_key(), some_pixels[1], {}};
  const std::uint32_t last = inspect(key).final_size;
  for (std::uint32_t step = 1; step < last; ++step) {
    const Inspection before = inspect({key.frame, key.pixel, step});
    const Inspection after = inspect({key.frame, key.pixel, step + 1});
    ASSERT_TRUE(before.refined_next) << step;
    std::vector<std::uint32_t> expected, found;
    for (const ClusterRow& row : before.clusters)
      if (row.node != *before.refined_next) expected.push_back(row.node);
    for (const std::uint32_t child : topology.children(*before.refined_next))
      expected.push_back(child);
    for (const ClusterRow& row : after.clusters) found.push_back(row.node);
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected)) << step;
  }
}

TEST(Inspect, FindsNothingBesideTheSurfaces) {
  InspectionKey key{small_key(), {0, 0}, {}};
  key.frame.camera.position *= 100; // out of the room, with the back to it
  key.frame.camera.target = 2.0F * key.frame.camera.position;
  const Inspection found = inspect(key);
  EXPECT_FALSE(found.sees_surface);
  EXPECT_THAT(found.clusters, IsEmpty());
  EXPECT_THAT(refinement_curve(key, 10, {}).size, IsEmpty());
  EXPECT_FALSE(row_of(key, 0));
  EXPECT_FALSE(inspect({small_key(), {32, 3}, {}}).sees_surface) << "beside the picture";
}

TEST(Inspect, OfACounterexampleIsTheSubjectsCutAtItsPoint) {
  const oracle::Counterexample c = counterexample_of(broken_cut);
  const auto scene = CounterexampleFile(broken_cut, c).open();
  const oracle::CaseView& view = c.on.views[scene->counterexample()->view];
  const auto seen = [&](std::uint32_t light) {
    return !std::binary_search(view.hidden.begin(), view.hidden.end(), light);
  };
  const auto tree = oracle::subject_named(broken_cut)->build(c.on.light_set(), c.on.seed);
  const auto library = oracle::subject_named("lightcuts")->build(c.on.light_set(), c.on.seed);
  bool differs = false;
  for (CutConfig cut : oracle::cuts_of(c.on.cut, c.on.lights.size())) {
    ShadingSettings settings;
    settings.threshold = cut.threshold;
    settings.max_cut = cut.max_size;
    cut.black_level = c.on.cut.black_level;
    const Inspection found =
        inspect({{scene, methods::lightcuts, settings, scene->scene().camera}, {0, 0}, {}});
    EXPECT_EQ(found.position, view.view.position);
    expect_cut(found, tree->select(view.view.point(), cut, seen));
    const Cut right = library->select(view.view.point(), cut, seen);
    differs = differs || found.clusters.size() != right.clusters.size();
  }
  EXPECT_TRUE(differs) << "or this test says nothing";
}

TEST(Inspect, OfACounterexampleShowsTheBoundThatIsBroken) {
  const auto scene = CounterexampleFile(broken_bound, counterexample_of(broken_bound)).open();
  const InspectionKey key{{scene, methods::lightcuts, {}, scene->scene().camera}, {0, 0}, 1U};
  Inspection found = inspect(key);
  ASSERT_THAT(found.clusters, SizeIs(1));
  EXPECT_EQ(found.clusters[0].node, scene->counterexample()->node);
  EXPECT_EQ(found.clusters[0].bound, scene->counterexample()->bound);
  ASSERT_TRUE(add_truth(key, found, {}));
  EXPECT_EQ(found.clusters[0].truth, scene->counterexample()->seen_truth);
}

} // namespace
} // namespace lightcuts::viz
