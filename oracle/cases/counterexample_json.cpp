// SPDX-License-Identifier: MIT
#include <oracle/cases/counterexample_json.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <oracle/cases/case_names.h>
#include <oracle/cases/hex_float.h>

namespace lightcuts::oracle {
namespace {

using Json = nlohmann::ordered_json;

/// As few digits as tell it from other floats; whole numbers without a fraction.
Json decimal(float value) {
  if (value == std::trunc(value) && std::abs(value) < 0x1p53F) return std::int64_t(value);
  const std::string text = fmt::format("{}", value);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

void put(Json& json, const std::string& key, float value) {
  json[key] = hex_text(value);
  json[key + "_decimal"] = decimal(value);
}

void put(Json& json, const std::string& key, const glm::vec3& v) {
  json[key] = {hex_text(v.x), hex_text(v.y), hex_text(v.z)};
  json[key + "_decimal"] = {decimal(v.x), decimal(v.y), decimal(v.z)};
}

Json json_of(const Light& light) {
  Json json{{"kind", name_of(light.kind)}};
  put(json, "position", light.position);
  put(json, "intensity", light.intensity);
  if ((only(light.kind) & kinds_with_axis) != 0) put(json, "axis", light.axis);
  if (light.kind == LightKind::spot) {
    put(json, "cos_inner", light.cos_inner);
    put(json, "cos_outer", light.cos_outer);
  }
  return json;
}

Json json_of(const Material& material) {
  Json json = Json::object();
  put(json, "diffuse", material.diffuse);
  if (!material.is_glossy()) return json;
  Json lobe{{"kind", name_of(material.lobe)}};
  if (const auto* phong = std::get_if<Phong>(&material.lobe)) {
    put(lobe, "reflectance", phong->reflectance);
    put(lobe, "exponent", phong->exponent);
  }
  if (const auto* ward = std::get_if<Ward>(&material.lobe)) {
    put(lobe, "reflectance", ward->reflectance);
    put(lobe, "alpha", ward->alpha);
  }
  if (const auto* cook = std::get_if<CookTorrance>(&material.lobe)) {
    put(lobe, "f0", cook->f0);
    put(lobe, "alpha", cook->alpha);
  }
  json["lobe"] = std::move(lobe);
  return json;
}

Json json_of(const CaseView& view) {
  Json json = Json::object();
  put(json, "position", view.view.position);
  put(json, "normal", view.view.normal);
  put(json, "to_viewer", view.view.to_viewer);
  json["material"] = json_of(view.view.material);
  json["hidden"] = view.hidden;
  return json;
}

Json json_of(const CutConfig& cut) {
  Json json = Json::object();
  put(json, "threshold", cut.threshold);
  json["max_size"] = cut.max_size;
  put(json, "black_level", cut.black_level);
  json["unoccluded"] = cut.unoccluded;
  return json;
}

Json json_of(const CaseTriangle& triangle) {
  Json json{{"mesh", triangle.mesh}};
  constexpr std::array names{"a", "b", "c"};
  for (std::size_t k = 0; k < 3; ++k) put(json, names[k], triangle.corners[k]);
  return json;
}

Json json_of(const Camera& camera) {
  Json json = Json::object();
  put(json, "position", camera.position);
  put(json, "target", camera.target);
  put(json, "up", camera.up);
  put(json, "vertical_fov", camera.vertical_fov);
  return json;
}

template <class T>
Json list_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(json_of(value));
  return list;
}

Json json_of(const Case& c) {
  Json json = Json::object();
  json["lights"] = list_of(c.lights);
  put(json, "min_distance", c.min_distance);
  json["views"] = list_of(c.views);
  json["cut"] = json_of(c.cut);
  json["seed"] = c.seed;
  const Case usual;
  if (!c.triangles.empty()) json["triangles"] = list_of(c.triangles);
  if (!c.triangles.empty() || c.camera != usual.camera) json["camera"] = json_of(c.camera);
  if (!c.triangles.empty() || c.image_size != usual.image_size)
    json["image_size"] = {c.image_size.x, c.image_size.y};
  return json;
}

std::string scalar_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_one_line(const Json& json) {
  if (!json.is_structured() || json.empty()) return true;
  if (json.is_object()) return false;
  return std::none_of(json.begin(), json.end(), [](const Json& j) { return j.is_structured(); });
}

/// Indented, but for lists of plain values.
void append(std::string& text, const Json& json, std::size_t indent) {
  if (!json.is_structured() || json.empty()) {
    text += scalar_text(json);
    return;
  }
  const std::string space = is_one_line(json) ? " " : "\n" + std::string(indent + 2, ' ');
  std::string before = is_one_line(json) ? "" : space;
  text += json.is_object() ? "{" : "[";
  for (const auto& [key, value] : json.items()) {
    text += before;
    if (json.is_object()) text += scalar_text(key) + ": ";
    append(text, value, indent + 2);
    before = "," + space;
  }
  if (!is_one_line(json)) text += "\n" + std::string(indent, ' ');
  text += json.is_object() ? "}" : "]";
}

} // namespace

std::string counterexample_json(const SavedCounterexample& saved) {
  const Counterexample& c = saved.counterexample;
  Json json{{"schema", counterexample_schema},
            {"subject", saved.subject},
            {"property", info(c.property).name},
            {"message", c.message},
            {"index", c.index}};
  json["case"] = json_of(c.on);
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

} // namespace lightcuts::oracle
