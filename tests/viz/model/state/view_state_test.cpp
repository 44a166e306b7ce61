// SPDX-License-Identifier: MIT
#include <viz/model/state/view_state.h>

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ViewState plain() {
  ViewState state;
  state.open.spec = "cloud";
  return state;
}

/// Nothing as by default.
ViewState chosen() {
  ViewState s;
  s.open = {"models/a \"room\".obj",  0xffff'ffff'ffff'ffffU,
            Builder::locally_ordered, 0.1F,
            glm::uvec2(123, 45),      4321};
  s.display = methods::stochastic;
  s.compared = DisplayMethod::raster();
  s.layer = layers::slack;
  s.split = true;
  s.split_at = 0.3F;
  s.pixel = {17, 4};
  s.node = 0;
  s.step = 9;
  s.shading.threshold = 0.07F;
  s.shading.max_cut = 123;
  s.shading.rules.bound = BoundRule::product;
  s.shading.rules.estimate = EstimateRule::unscaled;
  s.shading.tree_use = TreeUse::always;
  s.shading.seed = 0x8000'0000'0000'0001U;
  s.colours = {ColourMap::turbo, true, false, 0.01F, 33.3F, 1.7F};
  s.image = {1.1, {33.3, -7.7}, false};
  s.camera = Camera{{0.1F, -2, 1e-20F}, {1.5F, 3e30F, 0}, {0, 0.6F, 0.8F}, 33.3F};
  return s;
}

ViewState read_back(const ViewState& state) {
  return read_view_state("a.json", view_state_json(state));
}

TEST(ViewState, ComesBackFromJson) {
  EXPECT_EQ(read_back(plain()), plain());
  EXPECT_EQ(read_back(chosen()), chosen());
}

TEST(ViewState, ComesBackWithEveryChoiceOfAKind) {
  ViewState state = plain();
  for (const DisplayMethod& display : all_displays) {
    state.display = display;
    state.compared = next(display, 1);
    EXPECT_EQ(read_back(state), state) << name_of(display);
  }
  for (const Layer layer : all_layers) {
    state.layer = layer;
    EXPECT_EQ(read_back(state), state) << layer->name;
  }
  for (const ColourMap map : all_colour_maps) {
    state.colours.map = map;
    EXPECT_EQ(read_back(state), state) << name_of(map);
  }
  for (const auto bound : {BoundRule::joint, BoundRule::no_specular, BoundRule::product})
    for (const auto estimate :
         {EstimateRule::centroid, EstimateRule::representative, EstimateRule::unscaled}) {
      state.shading.rules.bound = bound;
      state.shading.rules.estimate = estimate;
      EXPECT_EQ(read_back(state), state);
    }
}

TEST(ViewState, ComesBackAtTheEndsOfItsDomain) {
  ViewState state = plain();
  state.shading.threshold = 0;
  state.shading.max_cut = 1;
  state.step = 0xffff'ffffU;
  state.node = 0xffff'ffffU;
  state.open.image_size = glm::uvec2(max_image_side, 1);
  state.image = {max_zoom, {1e-3, 16384}, false};
  EXPECT_EQ(read_back(state), state);
  state.shading.threshold = std::numeric_limits<float>::max();
  state.image.zoom = min_zoom;
  state.split = true;
  state.split_at = 0;
  EXPECT_EQ(read_back(state), state);
}

TEST(ViewState, LeavesOutWhatIsAsByDefault) {
  const json text = json::parse(view_state_json(plain()));
  for (const char* key :
       {"tree_seed", "builder", "min_distance", "image_size", "lights", "split", "pixel", "node",
        "step", "threshold", "range", "exposure", "zoom", "camera"})
    EXPECT_FALSE(text.contains(key)) << key;
  EXPECT_EQ(read_view_state("a.json", R"({"schema": "lightcuts-viz/view/1", "scene": "cloud"})"),
            plain());
}

TEST(ViewState, HasShortNumbersForPeople) {
  EXPECT_THAT(view_state_json(chosen()), HasSubstr("\"threshold\": 0.07,"));
}

struct Edit {
  const char* key;
  const char* value; ///< JSON
};
void PrintTo(const Edit& edit, std::ostream* out) { *out << edit.key << " " << edit.value; }

class BadViewState : public testing::TestWithParam<Edit> {};

TEST_P(BadViewState, IsRefusedWithTheNameOfTheMember) {
  json edited = json::parse(view_state_json(chosen()));
  edited[GetParam().key] = json::parse(GetParam().value);
  expect_refusal(std::string("a.json: /") + GetParam().key + " is",
                 [&] { (void)read_view_state("a.json", edited.dump()); });
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadViewState,
    testing::Values(
        Edit{"schema", "\"lightcuts-viz/view/2\""}, Edit{"schema", "1"}, Edit{"more", "1"},
        Edit{"scene", "7"}, Edit{"scene", "null"}, Edit{"builder", "\"Greedy\""},
        Edit{"tree_seed", "-1"}, Edit{"tree_seed", "1.5"},
        Edit{"tree_seed", "18446744073709551616"}, Edit{"min_distance", "0"},
        Edit{"min_distance", "\"1\""}, Edit{"image_size", "[0, 4]"}, Edit{"image_size", "[4]"},
        Edit{"image_size", "[4, 16385]"}, Edit{"image_size", "4"}, Edit{"lights", "0"},
        Edit{"lights", "4294967296"}, Edit{"method", "\"magic\""}, Edit{"method", "1"},
        Edit{"compared", "\"\""}, Edit{"layer", "\"cut\""}, Edit{"layer", "[]"},
        Edit{"split", "1.1"}, Edit{"split", "-0.1"}, Edit{"split", "true"},
        Edit{"pixel", "[-1, 0]"}, Edit{"pixel", "[1, 2, 3]"}, Edit{"node", "-1"},
        Edit{"node", "\"0\""}, Edit{"step", "0"}, Edit{"threshold", "-0.1"},
        Edit{"threshold", "1e39"}, Edit{"threshold", "null"}, Edit{"max_cut", "0"},
        Edit{"max_cut", "1.0"}, Edit{"bound", "\"paper\""}, Edit{"bound", "2"},
        Edit{"estimate", "\"joint\""}, Edit{"always_tree", "1"}, Edit{"seed", "-3"},
        Edit{"colour_map", "\"jet\""}, Edit{"colour_map", "0"}, Edit{"logarithmic", "\"yes\""},
        Edit{"range", "[1, 1]"}, Edit{"range", "[2, 1]"}, Edit{"range", "[1]"},
        Edit{"range", "[\"a\", 2]"}, Edit{"exposure", "0"}, Edit{"exposure", "false"},
        Edit{"zoom", "0"}, Edit{"zoom", "257"}, Edit{"centre", "[1]"}, Edit{"centre", "{}"},
        Edit{"camera", "[]"}, Edit{"camera", R"({"fov": 180})"}, Edit{"camera", R"({"fov": 0})"},
        Edit{"camera", R"({"eye": [0, 0, 0]})"}, Edit{"camera", R"({"position": [0, 0]})"},
        Edit{"camera", R"({"up": [0, 0, 1e39]})"}, Edit{"camera", R"({"up": [0, 0, 0]})"},
        Edit{"camera", R"({"position": [1, 2, 3], "target": [1, 2, 3]})"},
        Edit{"camera", R"({"position": [0, 3, 0], "target": [0, 0, 0], "up": [0, 1, 0]})"}));

TEST(BadViewState, WithoutASceneOrASchemaIsRefused) {
  for (const char* text : {"[]", "{}", "1", R"({"scene": "cloud"})"})
    expect_refusal("schema", [&] { (void)read_view_state("a.json", text); });
  expect_refusal("a.json: /scene is missing",
                 [] { (void)read_view_state("a.json", R"({"schema": "lightcuts-viz/view/1"})"); });
}

TEST(BadViewState, WithALogarithmOfZeroIsRefused) {
  for (const char* range : {"[0, 1]", "[-1, 1]"})
    expect_refusal("a.json: /range", [&] {
      (void)read_view_state("a.json", std::string(R"({"schema": "lightcuts-viz/view/1",)") +
                                          R"("scene": "cloud", "logarithmic": true, "range": )" +
                                          range + "}");
    });
}

TEST(BadViewState, ThatIsCutShortIsRefused) {
  const std::string text = view_state_json(chosen());
  for (std::size_t size = 0; size + 2 < text.size(); size += 5)
    expect_refusal("a.json: is no JSON",
                   [&] { (void)read_view_state("a.json", text.substr(0, size)); });
}

TEST(LoadViewState, ReadsAFileAndNamesOneThatIsNotThere) {
  const TemporaryFolder folder;
  const auto file = folder.path / "view.json";
  expect_refusal(file.string(), [&] { (void)load_view_state(file); });
  expect_refusal(folder.path.string(), [&] { (void)load_view_state(folder.path); });
  write(file, view_state_json(chosen()));
  EXPECT_EQ(load_view_state(file), chosen());
}

} // namespace
} // namespace lightcuts::viz
