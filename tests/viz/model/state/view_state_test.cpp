// SPDX-License-Identifier: MIT
#include <viz/model/state/view_state.h>

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/render/io/open_scene.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>
#include <tests/support/every_field.h>
#include <tests/support/member_count.h>

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

/// With numbers that the tests below look for.
ViewState chosen() {
  ViewState s;
  s.open = {"models/a \"room\".obj",
            glm::uvec2(123, 45),
            4321,
            5,
            "sky.exr",
            7,
            -33.5F,
            true,
            8,
            9,
            0.1F,
            3,
            0xffff'ffff'ffff'ffffU,
            Builder::locally_ordered,
            true,
            CameraRequest{{1, 2, 3}, {4, 5, 6}, 7.5F}};
  s.display = methods::stochastic;
  s.compared = DisplayMethod::raster();
  s.layer = layers::slack;
  s.split = true;
  s.split_at = 0.3F;
  s.pixel = {17, 4};
  s.node = 0; // by default none
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

template <class R>
class EveryRecordOfAView : public testing::Test {};
using Records = testing::Types<ViewState, SceneRequest, ShadingSettings, ClusterRules,
                               ColourSettings, ImageView, Camera, CameraRequest>;
TYPED_TEST_SUITE(EveryRecordOfAView, Records);

TYPED_TEST(EveryRecordOfAView, ListsAllItsMembers) {
  EXPECT_EQ(field_count<TypeParam>(), member_count<TypeParam>());
}

TEST(ViewState, ComesBackWithEveryFieldUnlikeItsDefault) {
  auto all = unlike_default<ViewState>();
  all.colours.lo = 0x1.23456p-3F;
  all.colours.hi = 0x1.6789acp+7F;
  const auto leaves = leaves_of(all);
  for (const auto& [path, bits] : leaves_of(ViewState{})) EXPECT_NE(leaves.at(path), bits) << path;
  EXPECT_EQ(leaves_of(read_back(all)), leaves);
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
       {"tree_seed", "builder", "min_distance", "image_size", "lights", "vpls", "split", "pixel",
        "node", "step", "threshold", "lo", "exposure", "zoom", "camera"})
    EXPECT_FALSE(text.contains(key)) << key;
  EXPECT_EQ(read_view_state("a.json", R"({"schema": "lightcuts-viz/view/2", "scene": "cloud"})"),
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
  expect_refusal(std::string("a.json: /") + GetParam().key,
                 [&] { (void)read_view_state("a.json", edited.dump()); });
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadViewState,
    testing::Values(
        Edit{"schema", "\"lightcuts-viz/view/1\""}, Edit{"schema", "1"}, Edit{"more", "1"},
        Edit{"scene", "7"}, Edit{"scene", "null"}, Edit{"builder", "\"Greedy\""},
        Edit{"tree_seed", "-1"}, Edit{"tree_seed", "1.5"},
        Edit{"tree_seed", "18446744073709551616"}, Edit{"min_distance", "0"},
        Edit{"min_distance", "\"1\""}, Edit{"image_size", "[0, 4]"}, Edit{"image_size", "[4]"},
        Edit{"image_size", "[4, 16385]"}, Edit{"image_size", "4"}, Edit{"lights", "-1"},
        Edit{"vpls", "1.5"}, Edit{"environment", "3"}, Edit{"lights", "4294967296"},
        Edit{"method", "\"magic\""}, Edit{"method", "1"}, Edit{"compared", "\"\""},
        Edit{"layer", "\"cut\""}, Edit{"layer", "[]"}, Edit{"split_at", "1.1"},
        Edit{"split_at", "-0.1"}, Edit{"split", "1"}, Edit{"pixel", "[-1, 0]"},
        Edit{"pixel", "[1, 2, 3]"}, Edit{"node", "-1"}, Edit{"node", "\"0\""}, Edit{"step", "0"},
        Edit{"threshold", "-0.1"}, Edit{"threshold", "1e39"}, Edit{"threshold", "null"},
        Edit{"max_cut", "0"}, Edit{"max_cut", "1.0"}, Edit{"bound", "\"paper\""},
        Edit{"bound", "2"}, Edit{"estimate", "\"joint\""}, Edit{"tree_use", "\"never\""},
        Edit{"seed", "-3"}, Edit{"colour_map", "\"jet\""}, Edit{"colour_map", "0"},
        Edit{"logarithmic", "\"yes\""}, Edit{"hi", "0.01"}, Edit{"hi", "[1]"}, Edit{"lo", "\"a\""},
        Edit{"lo", "0"}, Edit{"fits", "0"}, Edit{"exposure", "0"}, Edit{"exposure", "false"},
        Edit{"zoom", "0"}, Edit{"zoom", "257"}, Edit{"centre", "[1]"}, Edit{"centre", "{}"},
        Edit{"camera", "[]"}, Edit{"camera", R"({"eye": [0, 0, 0]})"},
        Edit{"camera", R"({"position": [0, 3, 0]})"}));

class BadCameraOfAView : public testing::TestWithParam<Edit> {};

TEST_P(BadCameraOfAView, IsRefused) {
  json edited = json::parse(view_state_json(chosen()));
  edited["camera"] = json::parse(
      R"({"position": [0, 3, 0], "target": [0, 0, 1], "up": [0, 0, 1], "vertical_fov": 40})");
  EXPECT_NO_THROW((void)read_view_state("a.json", edited.dump()));
  edited["camera"][GetParam().key] = json::parse(GetParam().value);
  expect_refusal("a.json: /camera", [&] { (void)read_view_state("a.json", edited.dump()); });
}

INSTANTIATE_TEST_SUITE_P(Values, BadCameraOfAView,
                         testing::Values(Edit{"vertical_fov", "180"}, Edit{"vertical_fov", "0"},
                                         Edit{"vertical_fov", "null"}, Edit{"position", "[0, 0]"},
                                         Edit{"up", "[0, 0, 1e39]"}, Edit{"up", "[0, 0, 0]"},
                                         Edit{"up", "[0, -6, 2]"}, Edit{"target", "[0, 3, 0]"}));

TEST(BadViewState, WithoutASceneOrASchemaIsRefused) {
  for (const char* text : {"[]", "1"})
    expect_refusal("expected an object", [&] { (void)read_view_state("a.json", text); });
  for (const char* text : {"{}", R"({"scene": "cloud"})"})
    expect_refusal("a.json: /schema is missing", [&] { (void)read_view_state("a.json", text); });
  expect_refusal("a.json: /scene is missing",
                 [] { (void)read_view_state("a.json", R"({"schema": "lightcuts-viz/view/2"})"); });
}

TEST(BadViewState, ThatIsCutShortIsRefused) {
  const std::string text = view_state_json(chosen());
  for (std::size_t size = 0; size + 2 < text.size(); size += 5)
    expect_refusal("a.json: line ", [&] { (void)read_view_state("a.json", text.substr(0, size)); });
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
