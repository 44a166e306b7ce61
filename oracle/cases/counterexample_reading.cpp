// SPDX-License-Identifier: MIT
#include <oracle/cases/counterexample_json.h>

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <lightcuts/render/io/json/json_element.h>
#include <lightcuts/render/io/json/json_text.h>
#include <lightcuts/render/io/text.h>
#include <lightcuts/render/view/camera.h>
#include <oracle/cases/case_names.h>
#include <oracle/cases/hex_float.h>

namespace lightcuts::oracle {
namespace {

constexpr float lowest = std::numeric_limits<float>::lowest();
constexpr float largest = std::numeric_limits<float>::max();
// A case is judged by brute force, pixel by pixel.
constexpr std::uint32_t max_image_side = 64;
constexpr std::uint32_t max_meshes = 1U << 16;

float float_of(const JsonElement& element, float least = lowest, float most = largest) {
  float value = 0;
  if (element.is_number()) {
    value = element.number();
  } else {
    const std::string text = element.string();
    const std::optional<float> read = hex_float(text);
    if (!read)
      element.refuse(fmt::format("is \"{}\", expected a finite float such as \"0x1.8p+1\"", text));
    value = *read;
  }
  if (value < least || value > most)
    element.refuse(least == 0 && most == largest
                       ? "is negative"
                       : fmt::format("is {}, expected {} to {}", value, least, most));
  return value;
}

std::size_t list_size(const JsonElement& element) {
  if (!element.is_list()) element.refuse("is not a list");
  return element.size();
}

glm::vec3 vector_of(const JsonElement& element, float least = lowest, float most = largest) {
  if (list_size(element) != 3)
    element.refuse(fmt::format("has {} elements, expected three", element.size()));
  return {float_of(element.at(0), least, most), float_of(element.at(1), least, most),
          float_of(element.at(2), least, most)};
}

// As LightSet demands it.
glm::vec3 unit_of(const JsonElement& element) {
  const glm::vec3 v = vector_of(element);
  const double length = glm::length(glm::dvec3(v));
  if (!(std::abs(length - 1) <= 1e-5)) element.refuse(fmt::format("has length {}, not 1", length));
  return v;
}

template <std::size_t N>
std::size_t index_among(const JsonElement& element, const std::array<const char*, N>& names) {
  const std::string name = element.string();
  for (std::size_t i = 0; i < N; ++i)
    if (name == names[i]) return i;
  element.refuse(fmt::format("is \"{}\", expected one of: {}", name, fmt::join(names, ", ")));
}

template <class T, class Read>
std::vector<T> list_of(const JsonElement& element, Read&& read) {
  std::vector<T> list;
  for (std::size_t i = 0; i < list_size(element); ++i) list.push_back(read(element.at(i)));
  return list;
}

void read_cone(const JsonElement& element, Light& light) {
  light.cos_inner = float_of(element["cos_inner"], -1, 1);
  light.cos_outer = float_of(element["cos_outer"], -1, 1);
  if (!(double(light.cos_inner) - light.cos_outer >= 0x1p-11))
    element["cos_inner"].refuse(
        fmt::format("is {}, expected at least cos_outer + 2^-11", light.cos_inner));
}

Light light_of(const JsonElement& element) {
  element.expect_keys({"kind", "position", "position_decimal", "intensity", "intensity_decimal",
                       "axis", "axis_decimal", "cos_inner", "cos_inner_decimal", "cos_outer",
                       "cos_outer_decimal"});
  Light light;
  light.kind = LightKind(index_among(element["kind"], light_kind_names));
  light.position = light.kind == LightKind::directional ? unit_of(element["position"])
                                                        : vector_of(element["position"]);
  light.intensity = vector_of(element["intensity"], 0);
  if ((only(light.kind) & kinds_with_axis) != 0) light.axis = unit_of(element["axis"]);
  if (light.kind == LightKind::spot) read_cone(element, light);
  return light;
}

Lobe lobe_of(const JsonElement& element) {
  element.expect_keys({"kind", "reflectance", "reflectance_decimal", "exponent", "exponent_decimal",
                       "f0", "f0_decimal", "alpha", "alpha_decimal"});
  switch (index_among(element["kind"], lobe_names)) {
  case 1:
    return Phong{vector_of(element["reflectance"], 0),
                 float_of(element["exponent"], 0, Phong::max_exponent)};
  case 2:
    return Ward{vector_of(element["reflectance"], 0),
                float_of(element["alpha"], Ward::min_alpha, 1)};
  case 3:
    return CookTorrance{vector_of(element["f0"], 0, 1),
                        float_of(element["alpha"], CookTorrance::min_alpha, 1)};
  default:
    return NoLobe{};
  }
}

Material material_of(const JsonElement& element) {
  element.expect_keys({"diffuse", "diffuse_decimal", "lobe"});
  Material material{vector_of(element["diffuse"], 0), {}};
  if (element.has("lobe")) material.lobe = lobe_of(element["lobe"]);
  return material;
}

std::vector<std::uint32_t> hidden_of(const JsonElement& element, std::size_t lights) {
  std::vector<std::uint32_t> hidden;
  if (list_size(element) > 0 && lights == 0) element.refuse("names lights, but there are none");
  for (std::size_t i = 0; i < element.size(); ++i) {
    const auto light = std::uint32_t(element.at(i).whole_number(0, lights - 1));
    if (!hidden.empty() && light <= hidden.back())
      element.at(i).refuse(fmt::format("is {}, expected more than the one before", light));
    hidden.push_back(light);
  }
  return hidden;
}

CaseView view_of(const JsonElement& element, std::size_t lights) {
  element.expect_keys({"position", "position_decimal", "normal", "normal_decimal", "to_viewer",
                       "to_viewer_decimal", "material", "hidden"});
  CaseView view;
  view.view.position = vector_of(element["position"]);
  view.view.normal = unit_of(element["normal"]);
  view.view.to_viewer = unit_of(element["to_viewer"]);
  view.view.material = material_of(element["material"]);
  view.hidden = hidden_of(element["hidden"], lights);
  return view;
}

CutConfig cut_of(const JsonElement& element) {
  element.expect_keys({"threshold", "threshold_decimal", "max_size", "black_level",
                       "black_level_decimal", "unoccluded"});
  CutConfig cut;
  cut.threshold = float_of(element["threshold"], 0);
  cut.max_size =
      std::uint32_t(element["max_size"].whole_number(1, std::numeric_limits<std::uint32_t>::max()));
  cut.black_level = float_of(element["black_level"], 0);
  cut.unoccluded = element["unoccluded"].boolean();
  return cut;
}

CaseTriangle triangle_of(const JsonElement& element) {
  element.expect_keys({"mesh", "a", "a_decimal", "b", "b_decimal", "c", "c_decimal"});
  return {{vector_of(element["a"]), vector_of(element["b"]), vector_of(element["c"])},
          std::uint32_t(element["mesh"].whole_number(0, max_meshes - 1))};
}

Camera camera_of(const JsonElement& element) {
  element.expect_keys({"position", "position_decimal", "target", "target_decimal", "up",
                       "up_decimal", "vertical_fov", "vertical_fov_decimal"});
  const Camera camera{vector_of(element["position"]), vector_of(element["target"]),
                      vector_of(element["up"]), float_of(element["vertical_fov"])};
  try {
    (void)PinholeView(camera, glm::uvec2(1));
  } catch (const InputError& error) {
    element.refuse_as(fmt::format(": {}", error.what()));
  }
  return camera;
}

glm::uvec2 image_size_of(const JsonElement& element) {
  if (list_size(element) != 2) element.refuse("is not a width and a height");
  return {element.at(0).whole_number(1, max_image_side),
          element.at(1).whole_number(1, max_image_side)};
}

Case case_of(const JsonElement& element) {
  element.expect_keys({"lights", "min_distance", "min_distance_decimal", "views", "cut", "seed",
                       "triangles", "camera", "image_size"});
  Case c;
  c.lights = list_of<Light>(element["lights"], light_of);
  c.min_distance = float_of(element["min_distance"], 0);
  c.views = list_of<CaseView>(
      element["views"], [&](const JsonElement& view) { return view_of(view, c.lights.size()); });
  c.cut = cut_of(element["cut"]);
  c.seed = element["seed"].whole_number(0, std::numeric_limits<std::uint64_t>::max());
  if (element.has("triangles"))
    c.triangles = list_of<CaseTriangle>(element["triangles"], triangle_of);
  if (element.has("camera")) c.camera = camera_of(element["camera"]);
  if (element.has("image_size")) c.image_size = image_size_of(element["image_size"]);
  return c;
}

Property property_of(const JsonElement& element) {
  const std::string name = element.string();
  const std::optional<Property> property = property_named(name);
  if (!property) element.refuse(fmt::format("is \"{}\", not the name of a property", name));
  return *property;
}

} // namespace

SavedCounterexample read_counterexample(const std::string& name, const std::string& text) {
  const nlohmann::json json = parse_json(name, text);
  const JsonElement root(name, json);
  root.expect_keys({"schema", "subject", "property", "message", "index", "case"});
  if (const std::string schema = root["schema"].string(); schema != counterexample_schema)
    root["schema"].refuse(fmt::format("is \"{}\", expected \"{}\"", schema, counterexample_schema));
  SavedCounterexample saved;
  saved.subject = root["subject"].string();
  if (saved.subject.empty()) root["subject"].refuse("is empty");
  Counterexample& c = saved.counterexample;
  c.property = property_of(root["property"]);
  c.message = root["message"].string();
  c.index = root["index"].whole_number(0, std::numeric_limits<std::uint64_t>::max());
  c.on = case_of(root["case"]);
  return saved;
}

SavedCounterexample load_counterexample(const std::filesystem::path& file) {
  return read_counterexample(file.string(), read_file(file));
}

} // namespace lightcuts::oracle
