// SPDX-License-Identifier: MIT
#include <viz/model/layers/layer_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/float_limits.h>
#include <tests/viz/support/small_pictures.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr glm::uvec2 frame_size{32, 24};
constexpr std::size_t frame_pixels = std::size_t(frame_size.x) * frame_size.y;

/// All that any layer needs, whole.
const LayerSources& whole() {
  static const LayerSources sources{
      made<Frame>(small_key()), made<Frame>(small_key(methods::reference)),
      made<TruthPicture>(small_key()), made<BlockPicture>(small_key(methods::block_cuts))};
  return sources;
}

double sum(const glm::vec3& v) { return double(v.x) + double(v.y) + double(v.z); }

double difference(const glm::vec3& a, const glm::vec3& b) {
  return std::abs(double(a.x) - b.x) + std::abs(double(a.y) - b.y) + std::abs(double(a.z) - b.z);
}

/// The formulas that LayerInfo::meaning states, written anew.
double expected(Layer layer, std::size_t i) {
  if (layer == layers::block_size) return whole().blocks->block_size()[i];
  if (layer == layers::proven) return whole().blocks->proven()[i];
  const Rendering& v = whole().frame->rendering();
  const Rendering& r = whole().reference->rendering();
  const double floor = 3 * double(small_scene()->black_level());
  const double e = difference(v.radiance[i], r.radiance[i]);
  const double certified = sum(v.certified_error[i]);
  const std::map<std::string, double> values{
      {"cut-size", v.cut_size[i]},
      {"shadow-rays", v.shadow_rays[i]},
      {"time", v.microseconds[i]},
      {"error", e / std::max(sum(r.radiance[i]), floor)},
      {"certified-error", certified / std::max(sum(v.radiance[i]), floor)},
      {"slack", e == 0 ? 0 : certified / e},
      {"clairvoyant", whole().truth->clairvoyant()[i]},
      {"violations", whole().truth->violations()[i]}};
  return values.at(layer->name);
}

TEST(LayerValues, AreTheirFormulasOfTheRenderings) {
  for (const Layer layer : all_layers) {
    if (layer == layers::image) continue;
    SCOPED_TRACE(layer->name);
    const LayerValues values = layer_values(layer, whole());
    ASSERT_EQ(values.values.size(), frame_pixels);
    EXPECT_EQ(values.size, frame_size);
    EXPECT_THAT(values.known, Each(1));
    EXPECT_TRUE(values.image.empty());
    for (std::size_t i = 0; i < frame_pixels; ++i)
      ASSERT_FLOAT_EQ(values.values[i], float(expected(layer, i))) << i;
  }
}

TEST(LayerValues, HaveMoreThanOneValue) {
  for (const Layer layer : std::initializer_list<Layer>{
           layers::cut_size, layers::shadow_rays, layers::error, layers::slack,
           layers::certified_error, layers::clairvoyant, layers::time}) {
    const LayerStatistics s = statistics_of(layer_values(layer, whole()));
    EXPECT_LT(s.least, s.largest) << layer->name;
  }
}

TEST(LayerValues, OfTheImageAreRadianceAndEmission) {
  const LayerValues values = layer_values(layers::image, whole());
  const Rendering& r = whole().frame->rendering();
  ASSERT_EQ(values.image.size(), frame_pixels);
  for (std::size_t i = 0; i < frame_pixels; ++i) {
    ASSERT_EQ(values.image[i], r.radiance[i] + r.emission[i]);
    ASSERT_EQ(values.surface[i] != 0,
              small_scene()->view().at({i % frame_size.x, i / frame_size.x}).has_value());
  }
}

TEST(LayerValues, SlackIsAtLeastOneWhereThereIsAnError) {
  const LayerValues slack = layer_values(layers::slack, whole());
  const LayerValues error = layer_values(layers::error, whole());
  for (std::size_t i = 0; i < frame_pixels; ++i)
    if (error.values[i] > 0) {
      EXPECT_GE(slack.values[i], 1);
    }
}

TEST(LayerValues, OfTheReferenceHaveNoError) {
  LayerSources sources = whole();
  sources.frame = sources.reference;
  EXPECT_THAT(layer_values(layers::error, sources).values, Each(0));
  EXPECT_THAT(layer_values(layers::slack, sources).values, Each(0));
}

TEST(LayerValues, ShowTheNearestPixelThatAllPicturesKnow) {
  for (const bool frame_is_coarse : {true, false}) {
    LayerSources sources = whole();
    if (frame_is_coarse)
      sources.frame = begun<Frame>(small_key());
    else
      sources.reference = begun<Frame>(small_key(methods::reference));
    const LayerValues values = layer_values(layers::error, sources);
    EXPECT_THAT(values.known, Each(1));
    for (std::size_t i = 0; i < frame_pixels; ++i) {
      const std::size_t x = i % frame_size.x / 16 * 16, y = i / frame_size.x / 16 * 16;
      ASSERT_FLOAT_EQ(values.values[i], float(expected(layers::error, y * frame_size.x + x))) << i;
    }
  }
}

TEST(LayerValues, KnowNothingBeforeThereIsAnything) {
  LayerSources sources = whole();
  sources.reference = std::make_shared<Frame>(small_key(methods::reference));
  EXPECT_THAT(layer_values(layers::error, sources).known, Each(0));
  EXPECT_THAT(layer_values(layers::cut_size, sources).known, Each(1)) << "needs none";
  EXPECT_FALSE(layer_value(layers::error, sources, {16, 12}));
  sources.truth = std::make_shared<TruthPicture>(small_key());
  EXPECT_THAT(layer_values(layers::violations, sources).known, Each(0));
  EXPECT_FALSE(layer_value(layers::violations, sources, {16, 12}));
}

TEST(LayerValues, GrowTheirVersionWithEveryPictureThatTheyNeed) {
  LayerSources sources{std::make_shared<Frame>(small_key()),
                       std::make_shared<Frame>(small_key(methods::reference)),
                       std::make_shared<TruthPicture>(small_key())};
  const auto versions = [&] {
    return std::array{version_of(layers::image, sources), version_of(layers::error, sources),
                      version_of(layers::clairvoyant, sources)};
  };
  const auto fresh = versions();
  std::const_pointer_cast<Frame>(sources.reference)->advance();
  EXPECT_EQ(versions()[0], fresh[0]);
  EXPECT_GT(versions()[1], fresh[1]);
  EXPECT_EQ(versions()[2], fresh[2]);
  const auto compared = versions();
  std::const_pointer_cast<Frame>(sources.frame)->advance();
  EXPECT_GT(versions()[0], compared[0]);
  EXPECT_GT(versions()[1], compared[1]);
  std::const_pointer_cast<TruthPicture>(sources.truth)->advance();
  EXPECT_GT(versions()[2], compared[2]);
}

TEST(LayerValue, IsThatOfThePixelItselfOnceItIsKnown) {
  const auto coarse = begun<Frame>(small_key());
  const LayerSources sources{coarse, nullptr, nullptr};
  for (std::size_t i = 0; i < frame_pixels; ++i) {
    const glm::uvec2 pixel{i % frame_size.x, i / frame_size.x};
    const auto value = layer_value(layers::cut_size, sources, pixel);
    EXPECT_EQ(value.has_value(), pixel.x % 16 == 0 && pixel.y % 16 == 0);
    if (value) {
      EXPECT_EQ(*value, whole().frame->rendering().cut_size[i]);
    }
    const auto error = layer_value(layers::error, whole(), pixel);
    ASSERT_TRUE(error);
    EXPECT_FLOAT_EQ(*error, float(expected(layers::error, i)));
  }
}

TEST(LayerValue, IsNothingWhereNoSurfaceIsSeen) {
  FrameKey key = small_key();
  key.camera.position *= 100; // out of the room, with the back to it
  key.camera.target = 2.0F * key.camera.position;
  const LayerSources sources{made<Frame>(key), nullptr, made<TruthPicture>(key)};
  ASSERT_FALSE(sources.frame->view().at({0, 0}));
  EXPECT_FALSE(layer_value(layers::cut_size, sources, {0, 0}));
  EXPECT_FALSE(layer_value(layers::clairvoyant, sources, {0, 0}));
  EXPECT_THAT(layer_values(layers::cut_size, sources).surface, Each(0));
  EXPECT_THAT(layer_values(layers::clairvoyant, sources).surface, Each(0));
}

/// A layer by hand: known pixels that see a surface.
LayerValues with_values(std::vector<float> values) {
  LayerValues layer;
  layer.size = {unsigned(values.size()), 1};
  layer.known.assign(values.size(), 1);
  layer.surface.assign(values.size(), 1);
  layer.values = std::move(values);
  return layer;
}

TEST(StatisticsOf, CountOnlyKnownPixelsThatSeeASurface) {
  LayerValues layer = with_values({0, 2, nan, inf, -inf, 1, 100, 200});
  layer.known[6] = 0;
  layer.surface[7] = 0;
  const LayerStatistics s = statistics_of(layer);
  EXPECT_EQ(s.known, 6U);
  EXPECT_EQ(s.nan, 1U);
  EXPECT_EQ(s.infinite, 2U);
  EXPECT_EQ(s.least, 0);
  EXPECT_EQ(s.largest, 2);
  EXPECT_EQ(s.least_positive, 1);
  EXPECT_EQ(s.mean, 1);
}

TEST(StatisticsOf, AreZeroWhereNothingIsFinite) {
  for (const auto& values : {std::vector<float>{}, {nan, inf}}) {
    const LayerStatistics s = statistics_of(with_values(values));
    EXPECT_EQ(s.least, 0);
    EXPECT_EQ(s.largest, 0);
    EXPECT_EQ(s.least_positive, 0);
    EXPECT_EQ(s.mean, 0);
  }
}

TEST(AutomaticScale, ShowsAllValues) {
  const LayerStatistics s = statistics_of(with_values({0.5F, 4, 0, inf}));
  const HeatMapScale linear = automatic_scale(s, false), log = automatic_scale(s, true);
  EXPECT_THAT((std::array{linear.lo, linear.hi}), ElementsAre(0, 4));
  EXPECT_FALSE(linear.logarithmic);
  EXPECT_THAT((std::array{log.lo, log.hi}), ElementsAre(0.5F, 4));
  EXPECT_TRUE(log.logarithmic);
}

TEST(AutomaticScale, IsAScaleWhateverThereIs) {
  for (const auto& values : {std::vector<float>{}, {0}, {3}, {nan}, {1e-45F}, {3e38F, 1e-45F}})
    for (const bool logarithmic : {false, true}) {
      const HeatMapScale scale = automatic_scale(statistics_of(with_values(values)), logarithmic);
      EXPECT_LT(scale.lo, scale.hi);
      EXPECT_TRUE(std::isfinite(scale.hi));
      EXPECT_EQ(scale.logarithmic, logarithmic);
      EXPECT_TRUE(logarithmic ? scale.lo > 0 : scale.lo == 0) << scale.lo;
    }
}

} // namespace
} // namespace lightcuts::viz
