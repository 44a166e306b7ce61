// SPDX-License-Identifier: MIT
#include <viz/model/layers/layer.h>

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace lightcuts::viz {
namespace {

TEST(Layer, IsFoundByItsName) {
  std::set<std::string> names, titles;
  for (const Layer layer : all_layers) {
    EXPECT_EQ(layer_named(info(layer).name), layer);
    names.insert(info(layer).name);
    titles.insert(info(layer).title);
  }
  EXPECT_EQ(names.size(), std::size(all_layers));
  EXPECT_EQ(titles.size(), std::size(all_layers));
  for (const char* name : {"", "Image", "cut", "cut-size ", "raster"})
    EXPECT_FALSE(layer_named(name)) << name;
}

TEST(Layer, SaysWhatItMeansInSentences) {
  for (const Layer layer : all_layers) {
    const std::string meaning = info(layer).meaning;
    EXPECT_GT(meaning.size(), 20U) << info(layer).name;
    EXPECT_EQ(meaning.back(), '.') << info(layer).name;
  }
}

TEST(Layer, CountsClustersRaysAndCasesInWholeNumbers) {
  const std::set<Layer> counts{Layer::cut_size, Layer::shadow_rays, Layer::clairvoyant,
                               Layer::violations};
  for (const Layer layer : all_layers)
    EXPECT_EQ(info(layer).whole_numbers, counts.contains(layer)) << info(layer).name;
}

TEST(Layer, NeedsTheReferenceForTrueErrorsAndTheTruthOnlyForWhatTheOracleSays) {
  const std::set<Layer> reference{Layer::error, Layer::slack};
  const std::set<Layer> truth{Layer::clairvoyant, Layer::violations};
  for (const Layer layer : all_layers) {
    EXPECT_EQ(needs_reference(layer), reference.contains(layer)) << info(layer).name;
    EXPECT_EQ(needs_truth(layer), truth.contains(layer)) << info(layer).name;
  }
}

} // namespace
} // namespace lightcuts::viz
