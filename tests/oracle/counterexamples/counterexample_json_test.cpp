// SPDX-License-Identifier: MIT
#include <oracle/cases/random_case.h>
#include <oracle/counterexamples/counterexample_json.h>

#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/all_features_case.h>
#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts::oracle {
namespace {

using nlohmann::json;
using testing::HasSubstr;

SavedCounterexample saved(const Case& on) {
  return {"mutant:heap-inverted", {Property::cut_obeys_threshold, on, "it \"says\" so\n", 7}};
}

Case read_back(const Case& on) {
  return read_counterexample("a.json", counterexample_json(saved(on))).counterexample.on;
}

RC_GTEST_PROP(CounterexampleJson, KeepsEveryBitOfACase, (std::uint64_t seed, std::uint64_t index)) {
  const Case on = random_case(seed, index);
  const std::string text = counterexample_json(saved(on));
  const SavedCounterexample read = read_counterexample("a.json", text);
  RC_ASSERT(read.counterexample.on == on);
  RC_ASSERT(counterexample_json(read) == text);
}

TEST(CounterexampleJson, KeepsEverythingElse) {
  const SavedCounterexample before = saved(all_features_case());
  const SavedCounterexample read = read_counterexample("a.json", counterexample_json(before));
  EXPECT_EQ(read.subject, "mutant:heap-inverted");
  EXPECT_EQ(read.counterexample.property, Property::cut_obeys_threshold);
  EXPECT_EQ(read.counterexample.message, "it \"says\" so\n");
  EXPECT_EQ(read.counterexample.index, 7U);
  EXPECT_EQ(read.counterexample.on, before.counterexample.on);
}

TEST(CounterexampleJson, KeepsExtremes) {
  Case on = all_features_case();
  on.seed = std::numeric_limits<std::uint64_t>::max();
  on.lights[0].position = {-0.0F, 0x1p-149F, -std::numeric_limits<float>::max()};
  on.cut.unoccluded = true;
  on.cut.max_size = std::numeric_limits<std::uint32_t>::max();
  const Case read = read_back(on);
  EXPECT_EQ(read, on);
  EXPECT_TRUE(std::signbit(read.lights[0].position.x));
}

TEST(CounterexampleJson, HasDecimalsForReadersThatDoNotCount) {
  Case on = all_features_case();
  on.lights[0].position = {0.1F, 3, -1.5F};
  std::string text = counterexample_json(saved(on));
  const std::string decimals = "\"position_decimal\": [0.1, 3, -1.5]";
  EXPECT_THAT(text, HasSubstr("\"position\": [\"0x1.99999ap-4\", \"0x1.8p+1\", \"-0x1.8p+0\"]"));
  ASSERT_THAT(text, HasSubstr(decimals));
  text.replace(text.find(decimals), decimals.size(), "\"position_decimal\": \"whatever\"");
  EXPECT_EQ(read_counterexample("a.json", text).counterexample.on, on);
}

TEST(CounterexampleJson, TakesPlainNumbersForHexadecimalOnes) {
  json edited = json::parse(counterexample_json(saved(all_features_case())));
  edited["case"]["lights"][0]["position"] = {1, 2.5, "0x1p+2"};
  const Case read = read_counterexample("a.json", edited.dump()).counterexample.on;
  EXPECT_EQ(read.lights[0].position, glm::vec3(1, 2.5F, 4));
}

struct Edit {
  const char* path;
  const char* value; ///< JSON
  const char* says;
};

class BadCounterexample : public testing::TestWithParam<Edit> {};

TEST_P(BadCounterexample, IsRefusedWithItsPlace) {
  json edited = json::parse(counterexample_json(saved(all_features_case())));
  edited[json::json_pointer(GetParam().path)] = json::parse(GetParam().value);
  const std::string says = std::string("a.json: ") + GetParam().says;
  expect_refusal(says, [&] { (void)read_counterexample("a.json", edited.dump()); });
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadCounterexample,
    testing::Values(
        Edit{"/schema", "\"lightcuts-oracle/check/1\"", "/schema is \"lightcuts-oracle/check/1\""},
        Edit{"/schema", "1", "/schema is a number, expected a string"},
        Edit{"/subject", "\"\"", "/subject is empty"},
        Edit{"/property", "\"bound-is-nice\"", "/property is \"bound-is-nice\""},
        Edit{"/index", "-1", "/index is -1"}, Edit{"/message", "null", "/message is null"},
        Edit{"/more", "1", "/more is unknown"}, Edit{"/case", "[]", "/case is an array"},
        Edit{"/case/seed", "1.5", "/case/seed is 1.5"},
        Edit{"/case/seed", "18446744073709551616", "/case/seed is 1.8446744073709552e+19"},
        Edit{"/case/lights", "{}", "/case/lights is not a list"},
        Edit{"/case/lights/0", "7", "/case/lights/0 is a number"},
        Edit{"/case/lights/0/kind", "\"sun\"", "/case/lights/0/kind is \"sun\""},
        Edit{"/case/lights/0/position", "[1, 2]", "/case/lights/0/position has 2 elements"},
        Edit{"/case/lights/0/position/1", "\"nan\"", "/case/lights/0/position/1 is \"nan\""},
        Edit{"/case/lights/0/position/1", "\"0xinf\"", "/case/lights/0/position/1 is \"0xinf\""},
        Edit{"/case/lights/0/position/1", "\"0x1p+128\"", "/case/lights/0/position/1 is"},
        Edit{"/case/lights/0/position/1", "\"0x1p+0 \"", "/case/lights/0/position/1 is"},
        Edit{"/case/lights/0/position/1", "\"0x-1p+0\"", "/case/lights/0/position/1 is"},
        Edit{"/case/lights/0/position/1", "\"\"", "/case/lights/0/position/1 is \"\""},
        Edit{"/case/lights/0/position/1", "1e39", "/case/lights/0/position/1 is 1e+39"},
        Edit{"/case/lights/0/intensity/2", "\"-0x1p+0\"", "/case/lights/0/intensity/2 is negative"},
        Edit{"/case/lights/1/axis", "[0, 0, 2]", "/case/lights/1/axis has length 2"},
        Edit{"/case/lights/2/cos_inner", "\"0x1.8p+0\"", "/case/lights/2/cos_inner is 1.5"},
        Edit{"/case/lights/2/cos_outer", "0.875", "/case/lights/2/cos_inner is 0.875"},
        Edit{"/case/lights/3/position", "[0, 0, 0]", "/case/lights/3/position has length 0"},
        Edit{"/case/min_distance", "-1", "/case/min_distance is negative"},
        Edit{"/case/views/0/normal", "[1, 1, 0]", "/case/views/0/normal has length 1.4142"},
        Edit{"/case/views/0/to_viewer", "[0, 0, 0]", "/case/views/0/to_viewer has length 0"},
        Edit{"/case/views/0/hidden", "[5]", "/case/views/0/hidden/0 is 5"},
        Edit{"/case/views/0/hidden", "[1, 1]", "/case/views/0/hidden/1 is 1"},
        Edit{"/case/views/0/material/diffuse/0", "-1", "/case/views/0/material/diffuse/0"},
        Edit{"/case/views/0/material/lobe/exponent", "1e9",
             "/case/views/0/material/lobe/exponent is 1000000000"},
        Edit{"/case/views/1/material/lobe/alpha", "0", "/case/views/1/material/lobe/alpha is 0"},
        Edit{"/case/views/2/material/lobe/f0/0", "2", "/case/views/2/material/lobe/f0/0 is 2"},
        Edit{"/case/cut/threshold", "-0.5", "/case/cut/threshold is negative"},
        Edit{"/case/cut/max_size", "0", "/case/cut/max_size is 0"},
        Edit{"/case/cut/unoccluded", "1", "/case/cut/unoccluded is a number"},
        Edit{"/case/triangles/0/mesh", "4294967295", "/case/triangles/0/mesh is 4294967295"},
        Edit{"/case/triangles/0/a", "null", "/case/triangles/0/a is not a list"},
        Edit{"/case/camera/up", "[0, 0, 0]", "/case/camera: camera: up is zero"},
        Edit{"/case/camera/vertical_fov", "180", "/case/camera: camera: vertical_fov"},
        Edit{"/case/image_size", "[100000, 2]", "/case/image_size/0 is 100000"},
        Edit{"/case/image_size", "[2]", "/case/image_size is not a list of two"}));

TEST(CounterexampleJson, RefusesWhateverIsMissing) {
  const json whole = json::parse(counterexample_json(saved(all_features_case())));
  for (const char* path : {"/schema", "/property", "/case", "/case/lights", "/case/views",
                           "/case/cut", "/case/seed", "/case/lights/2/cos_outer"}) {
    json edited = whole;
    const json::json_pointer pointer(path);
    edited[pointer.parent_pointer()].erase(pointer.back());
    expect_refusal(std::string(path) + " is missing",
                   [&] { (void)read_counterexample("a.json", edited.dump()); });
  }
}

TEST(CounterexampleJson, RefusesEveryTruncation) {
  const std::string text = counterexample_json(saved(all_features_case()));
  for (std::size_t size = 0; size + 2 < text.size(); size += 7)
    EXPECT_THROW((void)read_counterexample("a.json", text.substr(0, size)), InputError) << size;
}

TEST(CounterexampleJson, NamesAFileThatIsNotThere) {
  expect_refusal("nowhere.json", [] { (void)load_counterexample("nowhere.json"); });
  const TemporaryFolder folder;
  const auto file = folder.path / "a.json";
  std::ofstream(file) << counterexample_json(saved(all_features_case()));
  EXPECT_EQ(load_counterexample(file).counterexample.on, all_features_case());
}

} // namespace
} // namespace lightcuts::oracle
