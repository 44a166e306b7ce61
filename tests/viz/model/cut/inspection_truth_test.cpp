// SPDX-License-Identifier: MIT
#include <viz/model/cut/inspection.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/truth/truth.h>
#include <viz/model/picture/truth_picture.h>

#include <tests/viz/support/small_pictures.h>

namespace lightcuts::viz {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(AddTruth, SumsOverTheLightsThatAreSeen) {
  for (const glm::uvec2 pixel : some_pixels) {
    const InspectionKey key{small_key(), pixel, {}};
    Inspection found = inspect(key);
    EXPECT_TRUE(add_truth(key, found, {}));
    const SmallPoint at(pixel);
    const LightSet& lights = small_scene()->scene().lights;
    std::vector<glm::dvec3> of_light(lights.size(), glm::dvec3(0));
    glm::dvec3 total(0);
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      if (!at(i)) continue;
      const oracle::Wide w = oracle::contribution(lights[i], at.p.point, 0);
      of_light[i] = {double(w[0]), double(w[1]), double(w[2])};
      total += of_light[i];
    }
    ASSERT_TRUE(found.truth);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*found.truth)[c], total[c], 1e-12 * total[c]);
    for (const ClusterRow& row : found.clusters) {
      double red = 0;
      for (const std::uint32_t light : small_scene()->topology().all_lights(row.node))
        red += of_light[light].x;
      ASSERT_TRUE(row.truth);
      EXPECT_NEAR(row.truth->x, red, 1e-12 * total.x);
      EXPECT_LE(std::abs(row.truth->x - row.estimate.x), row.bound.x + 1e-6 * total.x);
    }
  }
}

TEST(AddTruth, FindsTheClairvoyantCutOfTheTruthPicture) {
  const auto truth = made<TruthPicture>(small_key());
  for (const glm::uvec2 pixel : some_pixels) {
    const InspectionKey key{small_key(), pixel, {}};
    Inspection found = inspect(key);
    ASSERT_TRUE(add_truth(key, found, {}));
    EXPECT_EQ(float(found.clairvoyant.value()),
              truth->clairvoyant()[std::size_t(pixel.y) * 32 + pixel.x]);
    EXPECT_LE(*found.clairvoyant, found.final_size);
  }
}

TEST(AddTruth, ChangesNothingWhereItIsCancelled) {
  const InspectionKey key{small_key(), some_pixels[0], {}};
  Inspection found = inspect(key);
  EXPECT_FALSE(add_truth(key, found, Progress::until([] { return true; })));
  EXPECT_FALSE(found.truth);
  EXPECT_FALSE(found.clusters.front().truth);
}

TEST(RefinementCurve, IsThatOfTheStepsThemselves) {
  const InspectionKey key{small_key(), some_pixels[0], {}};
  const RefinementCurve curve = refinement_curve(key, 12, {});
  ASSERT_THAT(curve.size, testing::AllOf(testing::Not(IsEmpty()), SizeIs(testing::Le(12))));
  EXPECT_EQ(curve.size.front(), 1);
  EXPECT_EQ(curve.size.back(), inspect(key).final_size);
  EXPECT_TRUE(std::is_sorted(curve.size.begin(), curve.size.end()));
  for (std::size_t i = 0; i < curve.size.size(); ++i) {
    const Inspection step = inspect({key.frame, key.pixel, std::uint32_t(curve.size[i])});
    double total = 0, largest = 0;
    for (const ClusterRow& row : step.clusters) {
      total += row.estimate.x + row.estimate.y + row.estimate.z;
      largest = std::max(largest, double(row.bound.x) + row.bound.y + row.bound.z);
    }
    const glm::dvec3 certified(step.certified_error);
    EXPECT_NEAR(curve.total[i], total, 1e-12 * total);
    EXPECT_NEAR(curve.largest_bound[i], largest, 1e-12 * largest);
    EXPECT_NEAR(curve.certified[i], certified.x + certified.y + certified.z, 1e-9);
  }
}

TEST(RefinementCurve, HasEverySizeWhereThereIsRoomAndNoneWhereItIsCancelled) {
  const InspectionKey key{small_key(), some_pixels[0], {}};
  EXPECT_GT(refinement_curve(key, 10'000, {}).size.size(), 8U);
  EXPECT_THAT(refinement_curve(key, 10, Progress::until([] { return true; })).size, IsEmpty());
}

TEST(RowOf, IsTheCutsOwnRowForEveryClusterOfIt) {
  std::size_t hidden = 0;
  for (const Method method :
       std::initializer_list<Method>{methods::lightcuts, methods::reference, methods::paper,
                                     methods::unscaled, methods::no_specular_bound})
    for (unsigned i = 0; i < 32 * 24; i += 5) {
      const InspectionKey key{small_key(method), {i % 32, i / 32}, {}};
      for (const ClusterRow& expected : inspect(key).clusters) {
        const auto row = row_of(key, expected.node);
        ASSERT_TRUE(row);
        ASSERT_EQ(row->bound, expected.bound) << method->name << " " << expected.lights;
        ASSERT_EQ(row->estimate, expected.estimate) << method->name;
        ASSERT_EQ(row->visible, expected.visible) << method->name;
        ASSERT_EQ(row->share, expected.share) << method->name;
        ASSERT_EQ(row->representative, expected.representative);
        ASSERT_EQ(row->distance, expected.distance);
        hidden += row->visible ? 0 : 1;
      }
    }
  EXPECT_GT(hidden, 0U) << "or this test says little";
}

TEST(RowOf, IsThatOfAStepForAClusterAboveTheCut) {
  const InspectionKey key{small_key(), some_pixels[0], {}};
  for (const std::uint32_t step : {1U, 3U, 6U})
    for (const ClusterRow& expected : inspect({key.frame, key.pixel, step}).clusters) {
      const auto row = row_of(key, expected.node);
      ASSERT_TRUE(row);
      EXPECT_EQ(row->bound, expected.bound);
      EXPECT_EQ(row->estimate, expected.estimate);
    }
  EXPECT_FALSE(row_of(key, 399)) << "there is none";
}

} // namespace
} // namespace lightcuts::viz
