// SPDX-License-Identifier: MIT
#include <viz/model/layers/all_layers.h>

#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tests/support/readme.h>

namespace lightcuts::viz {
namespace {

TEST(Layer, IsFoundByItsName) {
  std::set<std::string> names, titles;
  for (const Layer layer : all_layers) {
    EXPECT_EQ(value_named<Layer>(layer->name), layer);
    names.insert(layer->name);
    titles.insert(layer->title);
  }
  EXPECT_EQ(names.size(), std::size(all_layers));
  EXPECT_EQ(titles.size(), std::size(all_layers));
  for (const char* name : {"", "Image", "cut", "cut-size ", "raster"})
    EXPECT_FALSE(value_named<Layer>(name)) << name;
}

TEST(Layer, SaysWhatItMeansInSentences) {
  for (const Layer layer : all_layers) {
    const std::string meaning = layer->meaning;
    EXPECT_GT(meaning.size(), 20U) << layer->name;
    EXPECT_EQ(meaning.back(), '.') << layer->name;
  }
}

TEST(Layer, StandsInTheReadmesTableInItsOrder) {
  std::string table = "| layer | |\n|---|---|\n";
  for (const Layer layer : all_layers) {
    std::string meaning = layer->meaning;
    for (std::size_t at = meaning.find('|'); at != std::string::npos;
         at = meaning.find('|', at + 2))
      meaning.insert(at, 1, '\\'); // else it would end the column
    table += fmt::format("| `{}` | {} |\n", layer->name, meaning);
  }
  EXPECT_NE(test::readme().find(table + "\n"), std::string::npos) << "README.md should have:\n"
                                                                  << table;
}

using Names = std::set<std::string>;

/// Of the layers for which the predicate holds.
template <class Predicate>
Names names_where(Predicate&& holds) {
  Names names;
  for (const Layer layer : all_layers)
    if (holds(layer)) names.insert(layer->name);
  return names;
}

TEST(Layer, CountsClustersRaysAndCasesInWholeNumbers) {
  EXPECT_EQ(names_where([](Layer layer) { return layer->whole_numbers; }),
            (Names{"cut-size", "shadow-rays", "block-size", "clairvoyant", "violations"}));
}

TEST(Layer, NeedsTheReferenceForTrueErrorsAndTheTruthOnlyForWhatTheOracleSays) {
  EXPECT_EQ(names_where([](Layer layer) { return layer.needs_reference(); }),
            (Names{"error", "slack"}));
  EXPECT_EQ(names_where([](Layer layer) { return layer.needs_truth(); }),
            (Names{"clairvoyant", "violations"}));
  EXPECT_EQ(names_where([](Layer layer) { return layer.needs_blocks(); }),
            (Names{"block-size", "proven"}));
}

TEST(Layer, HasEitherAValueOrAColour) {
  for (const Layer layer : all_layers)
    EXPECT_NE(layer->value == nullptr, layer->colour == nullptr) << layer->name;
}

TEST(Layer, GoesRoundInTheOrderOfTheTable) {
  Layer layer = layers::image;
  for (const Layer expected : all_layers) {
    EXPECT_EQ(layer, expected);
    EXPECT_EQ(next(next(layer, 1), -1), layer);
    layer = next(layer, 1);
  }
  EXPECT_EQ(layer, Layer(layers::image));
}

} // namespace
} // namespace lightcuts::viz
