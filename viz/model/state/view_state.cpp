// SPDX-License-Identifier: MIT
#include <viz/model/state/view_state.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/camera.h>
#include <nlohmann/json.hpp>

#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "lightcuts-viz/view/1";

constexpr const char* bound_names[] = {"joint", "no-specular", "product"};
constexpr const char* estimate_names[] = {"centroid", "representative", "unscaled"};

/// A float as its shortest decimal.
double decimal(float v) { return std::stod(fmt::format("{}", v)); }
Json decimals(const glm::vec3& v) { return {decimal(v.x), decimal(v.y), decimal(v.z)}; }

void write_shading(const ShadingSettings& s, Json& json) {
  if (s.threshold) json["threshold"] = decimal(*s.threshold);
  json["max_cut"] = s.max_cut;
  json["bound"] = name_of(s.rules.bound);
  json["estimate"] = name_of(s.rules.estimate);
  json["always_tree"] = s.tree_use == TreeUse::always;
  json["seed"] = s.seed;
}

void write_colours(const ColourSettings& c, Json& json) {
  json["colour_map"] = name_of(c.map);
  json["logarithmic"] = c.logarithmic;
  if (!c.automatic_range) json["range"] = {decimal(c.lo), decimal(c.hi)};
  if (c.exposure) json["exposure"] = decimal(*c.exposure);
}

void write_camera(const Camera& c, Json& json) {
  json["camera"] = {{"position", decimals(c.position)},
                    {"target", decimals(c.target)},
                    {"up", decimals(c.up)},
                    {"fov", decimal(c.vertical_fov)}};
}

/// Says what is wrong with a member.
struct Fault {
  std::string what;
};

double wide(const Json& json, double least, double most) {
  const double value = json.is_number() ? json.get<double>() : NAN;
  if (!(value >= least && value <= most))
    throw Fault{fmt::format("expected a number from {} to {}", least, most)};
  return value;
}

float number(const Json& json, double least, double most) {
  return static_cast<float>(wide(json, least, most));
}

template <class Integer>
Integer whole(const Json& json, Integer least) {
  constexpr auto most = std::numeric_limits<Integer>::max();
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most ||
      json.get<std::uint64_t>() < least)
    throw Fault{fmt::format("expected a whole number from {} to {}", least, most)};
  return json.get<Integer>();
}

bool boolean(const Json& json) {
  if (!json.is_boolean()) throw Fault{"expected true or false"};
  return json.get<bool>();
}

std::string text(const Json& json) {
  if (!json.is_string()) throw Fault{"expected a text"};
  return json.get<std::string>();
}

template <class Find>
auto named(const Json& json, Find&& find) {
  const auto found = find(text(json));
  if (!found) throw Fault{fmt::format("'{}' is unknown", text(json))};
  return *found;
}

const Json& list(const Json& json, std::size_t size) {
  if (!json.is_array() || json.size() != size)
    throw Fault{fmt::format("expected a list of {} numbers", size)};
  return json;
}

constexpr double largest = 3.4028235e38; // the largest float as decimal() writes it

glm::vec3 vector(const Json& json) {
  list(json, 3);
  return {number(json[0], -largest, largest), number(json[1], -largest, largest),
          number(json[2], -largest, largest)};
}

glm::uvec2 pixel(const Json& json, unsigned least) {
  list(json, 2);
  return {whole<unsigned>(json[0], least), whole<unsigned>(json[1], least)};
}

template <class Enum, std::size_t n>
Enum one_of(const Json& json, const char* const (&names)[n]) {
  for (std::size_t i = 0; i < n; ++i)
    if (json == names[i]) return Enum(i);
  throw Fault{fmt::format("expected one of {}", fmt::join(names, ", "))};
}

std::optional<ColourMap> map_named(const std::string& name) {
  for (const ColourMap map : all_colour_maps)
    if (name == name_of(map)) return map;
  return std::nullopt;
}

Camera camera(const Json& json) {
  if (!json.is_object()) throw Fault{"expected an object"};
  Camera c;
  for (const auto& [key, value] : json.items()) {
    if (key == "position")
      c.position = vector(value);
    else if (key == "target")
      c.target = vector(value);
    else if (key == "up")
      c.up = vector(value);
    else if (key == "fov")
      c.vertical_fov = number(value, 1e-3, 179.99);
    else
      throw Fault{fmt::format("'{}' is unknown", key)};
  }
  try {
    (void)PinholeView(c, glm::uvec2(1));
  } catch (const InputError& error) {
    throw Fault{error.what()};
  }
  return c;
}

using Reader = std::function<void(const Json&, ViewState&)>;

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all{
      {"schema", [](const Json&, ViewState&) {}},
      {"scene", [](const Json& j, ViewState& s) { s.open.spec = text(j); }},
      {"tree_seed",
       [](const Json& j, ViewState& s) { s.open.tree_seed = whole<std::uint64_t>(j, 0); }},
      {"builder", [](const Json& j, ViewState& s) { s.open.builder = named(j, builder_named); }},
      {"min_distance",
       [](const Json& j, ViewState& s) { s.open.min_distance = number(j, 1e-30, 1e30); }},
      {"image_size",
       [](const Json& j, ViewState& s) {
         s.open.image_size = pixel(j, 1);
         if (s.open.image_size->x > max_image_side || s.open.image_size->y > max_image_side)
           throw Fault{fmt::format("sides are at most {} pixels", max_image_side)};
       }},
      {"lights", [](const Json& j, ViewState& s) { s.open.lights = whole<std::uint32_t>(j, 1); }},
      {"method", [](const Json& j, ViewState& s) { s.display = named(j, display_named); }},
      {"compared", [](const Json& j, ViewState& s) { s.compared = named(j, display_named); }},
      {"layer", [](const Json& j, ViewState& s) { s.layer = named(j, layer_named); }},
      {"split",
       [](const Json& j, ViewState& s) {
         s.split = true;
         s.split_at = number(j, 0, 1);
       }},
      {"pixel", [](const Json& j, ViewState& s) { s.pixel = pixel(j, 0); }},
      {"node", [](const Json& j, ViewState& s) { s.node = whole<std::uint32_t>(j, 0); }},
      {"step", [](const Json& j, ViewState& s) { s.step = whole<std::uint32_t>(j, 1); }},
      {"threshold",
       [](const Json& j, ViewState& s) { s.shading.threshold = number(j, 0, largest); }},
      {"max_cut",
       [](const Json& j, ViewState& s) { s.shading.max_cut = whole<std::uint32_t>(j, 1); }},
      {"bound", [](const Json& j,
                   ViewState& s) { s.shading.rules.bound = one_of<BoundRule>(j, bound_names); }},
      {"estimate",
       [](const Json& j, ViewState& s) {
         s.shading.rules.estimate = one_of<EstimateRule>(j, estimate_names);
       }},
      {"always_tree",
       [](const Json& j, ViewState& s) {
         s.shading.tree_use = boolean(j) ? TreeUse::always : TreeUse::automatic;
       }},
      {"seed", [](const Json& j, ViewState& s) { s.shading.seed = whole<std::uint64_t>(j, 0); }},
      {"colour_map", [](const Json& j, ViewState& s) { s.colours.map = named(j, map_named); }},
      {"logarithmic", [](const Json& j, ViewState& s) { s.colours.logarithmic = boolean(j); }},
      {"range",
       [](const Json& j, ViewState& s) {
         list(j, 2);
         s.colours.automatic_range = false;
         s.colours.lo = number(j[0], -largest, largest);
         s.colours.hi = number(j[1], -largest, largest);
         if (s.colours.lo >= s.colours.hi) throw Fault{"expected two numbers that rise"};
       }},
      {"exposure",
       [](const Json& j, ViewState& s) { s.colours.exposure = number(j, 1e-30, 1e30); }},
      {"zoom",
       [](const Json& j, ViewState& s) {
         s.image.fits = false;
         s.image.zoom = wide(j, min_zoom, max_zoom);
       }},
      {"centre",
       [](const Json& j, ViewState& s) {
         list(j, 2);
         s.image.centre = {wide(j[0], -largest, largest), wide(j[1], -largest, largest)};
       }},
      {"camera", [](const Json& j, ViewState& s) { s.camera = camera(j); }},
  };
  return all;
}

Json parsed(const std::string& name, const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError(InputFault::malformed_file,
                     fmt::format("{}: is no JSON: {}", name, error.what()));
  }
}

void require_schema(const std::string& name, const Json& json) {
  if (!json.is_object() || !json.contains("schema"))
    throw InputError(InputFault::malformed_file,
                     name + ": is no state of a view: it has no \"schema\"");
  if (json["schema"] != schema)
    throw InputError(InputFault::unsupported,
                     fmt::format("{}: /schema is {}, expected \"{}\": it is of another version",
                                 name, json["schema"].dump(), schema));
}

} // namespace

std::string view_state_json(const ViewState& s) {
  Json json{{"schema", schema}, {"scene", s.open.spec}};
  if (s.open.tree_seed != 1) json["tree_seed"] = s.open.tree_seed;
  if (s.open.builder != Builder::greedy) json["builder"] = name_of(s.open.builder);
  if (s.open.min_distance) json["min_distance"] = decimal(*s.open.min_distance);
  if (s.open.image_size) json["image_size"] = {s.open.image_size->x, s.open.image_size->y};
  if (s.open.lights > 0) json["lights"] = s.open.lights;
  json["method"] = name_of(s.display);
  json["compared"] = name_of(s.compared);
  json["layer"] = s.layer->name;
  if (s.split) json["split"] = decimal(s.split_at);
  if (s.pixel) json["pixel"] = {s.pixel->x, s.pixel->y};
  if (s.node) json["node"] = *s.node;
  if (s.step) json["step"] = *s.step;
  write_shading(s.shading, json);
  write_colours(s.colours, json);
  if (!s.image.fits) {
    json["zoom"] = s.image.zoom;
    json["centre"] = {s.image.centre.x, s.image.centre.y};
  }
  if (s.camera) write_camera(*s.camera, json);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ViewState read_view_state(const std::string& name, const std::string& text) {
  const Json json = parsed(name, text);
  require_schema(name, json);
  ViewState state;
  for (const auto& [key, value] : json.items()) {
    const auto reader = readers().find(key);
    if (reader == readers().end())
      throw InputError(InputFault::unknown_name, fmt::format("{}: /{} is unknown", name, key));
    try {
      reader->second(value, state);
    } catch (const Fault& fault) {
      throw InputError(InputFault::malformed_file,
                       fmt::format("{}: /{} is {}: {}", name, key, value.dump(), fault.what));
    }
  }
  if (state.open.spec.empty()) throw InputError(InputFault::missing, name + ": /scene is missing");
  if (state.colours.logarithmic && !state.colours.automatic_range && state.colours.lo <= 0)
    throw InputError(InputFault::out_of_domain,
                     name + ": /range begins at or below 0, and is logarithmic");
  return state;
}

ViewState load_view_state(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw InputError(InputFault::unreadable_file, file.string() + ": cannot be read");
  return read_view_state(file.string(), content.str());
}

} // namespace lightcuts::viz
