// SPDX-License-Identifier: MIT
#include <oracle/report/pages/report_json.h>

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <tests/oracle/support/made_up_report.h>

namespace lightcuts::oracle {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

TEST(ReportJson, has_the_keys_of_the_schema_in_order) {
  const Json written = Json::parse(report_json(made_up_report()));
  EXPECT_EQ(written["schema"], "lightcuts-oracle/report/1");
  EXPECT_EQ(keys_of(written),
            (std::vector<std::string>{"schema", "scene", "seed", "builder", "lights", "triangles",
                                      "width", "height", "surface_pixels", "threads", "repeats",
                                      "black_level", "needs", "left_out", "runs"}));
  EXPECT_EQ(
      keys_of(written["runs"][0]),
      (std::vector<std::string>{
          "method", "threshold", "build_seconds", "render_seconds", "mean_cut_size",
          "shadow_rays_per_pixel", "rel_rmse", "mrse", "mean_relative_error", "max_relative_error",
          "mean_certified_error", "pixels_over_threshold", "dark_pixels", "size_limited_pixels",
          "speedup_over_reference", "efficiency", "optimal_cut_size", "cut_efficiency"}));
}

TEST(ReportJson, keeps_every_value) {
  const Report report = made_up_report();
  const Json written = Json::parse(report_json(report));
  EXPECT_EQ(written["width"], 640);
  EXPECT_EQ(written["left_out"][0], report.left_out[0]);
  ASSERT_EQ(written["runs"].size(), 3U);
  EXPECT_EQ(written["runs"][1]["method"], "lightcuts");
  EXPECT_EQ(written["runs"][1]["rel_rmse"].get<double>(), report.runs[1].rel_rmse);
  EXPECT_EQ(written["runs"][1]["pixels_over_threshold"], 41);
}

TEST(ReportJson, writes_a_float_with_its_own_digits) {
  EXPECT_NE(report_json(made_up_report()).find("\"black_level\": 0.001,"), std::string::npos);
}

TEST(ReportJson, writes_null_for_what_is_not_finite) {
  Report report = made_up_report();
  report.runs[1].mrse = std::numeric_limits<double>::quiet_NaN();
  report.runs[1].efficiency = std::numeric_limits<double>::infinity();
  report.black_level = std::numeric_limits<float>::infinity();
  const Json written = Json::parse(report_json(report));
  EXPECT_TRUE(written["runs"][1]["mrse"].is_null());
  EXPECT_TRUE(written["runs"][1]["efficiency"].is_null());
  EXPECT_TRUE(written["black_level"].is_null());
}

TEST(ReportJson, survives_a_scene_name_that_is_not_utf8) {
  Report report = made_up_report();
  report.scene = "a\xff\"b";
  EXPECT_EQ(Json::parse(report_json(report))["scene"], "a\xef\xbf\xbd\"b");
}

TEST(ReportJson, has_arrays_where_there_is_nothing) {
  const std::string text = report_json({});
  const Json written = Json::parse(text);
  EXPECT_TRUE(written["runs"].is_array() && written["needs"].is_array());
  EXPECT_EQ(text.back(), '\n');
}

} // namespace
} // namespace lightcuts::oracle
