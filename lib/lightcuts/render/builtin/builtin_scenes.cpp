// SPDX-License-Identifier: MIT
#include <lightcuts/render/builtin/builtin_scenes.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/lighting/light_generator.h>

#include <lightcuts/render/builtin/builtin_makers.h>

namespace lightcuts {
namespace {

struct Parameter {
  std::string scene, name, value;
};

std::string_view name_of(std::string_view spec) { return spec.substr(0, spec.find('?')); }

std::vector<Parameter> parameters_of(const std::string& spec) {
  const std::string scene(name_of(spec));
  std::vector<Parameter> parameters;
  std::size_t begin = scene.size() + 1;
  while (begin < spec.size()) {
    const std::size_t end = std::min(spec.find('&', begin), spec.size());
    const std::string item = spec.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos)
      throw InputError(InputFault::missing,
                       fmt::format("{}: parameter '{}' has no value", scene, item));
    const std::string name = item.substr(0, equals);
    for (const Parameter& earlier : parameters)
      if (earlier.name == name)
        throw InputError(InputFault::inconsistent,
                         fmt::format("{}: parameter '{}' is given twice", scene, name));
    parameters.push_back({scene, name, item.substr(equals + 1)});
    begin = end + 1;
  }
  return parameters;
}

std::uint64_t whole_number(const Parameter& p, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const char* end = p.value.data() + p.value.size();
  const auto [stop, error] = std::from_chars(p.value.data(), end, number);
  if (error == std::errc::invalid_argument || stop != end)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("{}: parameter '{}' is '{}', expected a whole number", p.scene,
                                 p.name, p.value));
  if (error != std::errc{} || number < least || number > most)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("{}: parameter '{}' is {}, expected {} to {}", p.scene, p.name,
                                 p.value, least, most));
  return number;
}

/// The index of the parameter's value among these.
std::size_t choice(const Parameter& p, const std::vector<const char*>& values) {
  const auto found = std::find(values.begin(), values.end(), p.value);
  if (found == values.end())
    throw InputError(InputFault::unknown_name,
                     fmt::format("{}: parameter '{}' is '{}', expected one of {}", p.scene, p.name,
                                 p.value, fmt::join(values, ", ")));
  return std::size_t(found - values.begin());
}

float metres(const Parameter& p) {
  float number = 0;
  const char* end = p.value.data() + p.value.size();
  const auto [stop, error] = std::from_chars(p.value.data(), end, number);
  if (error != std::errc{} || stop != end || !(number > 0) || std::isinf(number))
    throw InputError(fault_of(number),
                     fmt::format("{}: parameter '{}' is '{}', expected a number above 0", p.scene,
                                 p.name, p.value));
  return number;
}

std::vector<const char*> materials_of_clouds() {
  std::vector<const char*> names;
  for (const Gloss& gloss : glosses) names.push_back(gloss.name);
  return names;
}

std::vector<const char*> kinds_of_clouds() {
  const auto kinds = names_of(LightKind());
  std::vector<const char*> names(kinds.begin(), kinds.end());
  names.push_back("mixed");
  return names;
}

std::optional<LightKind> kind_of(const Parameter& p) {
  const std::size_t index = choice(p, kinds_of_clouds());
  return index < light_kind_count ? std::optional(LightKind(index)) : std::nullopt;
}

CloudScene cloud_of(const std::string& spec) {
  CloudScene cloud;
  for (const Parameter& p : parameters_of(spec)) {
    if (p.name == "lights")
      cloud.lights = static_cast<std::uint32_t>(whole_number(p, 1, LightCloud::max_count));
    else if (p.name == "blocks")
      cloud.blocks = static_cast<std::uint32_t>(whole_number(p, 0, CloudScene::max_blocks));
    else if (p.name == "material")
      cloud.gloss = &glosses[choice(p, materials_of_clouds())];
    else if (p.name == "kind")
      cloud.kind = kind_of(p);
    else if (p.name == "clamp")
      cloud.clamp = metres(p);
    else if (p.name == "seed")
      cloud.seed = whole_number(p, 0, std::numeric_limits<std::uint64_t>::max());
    else
      throw InputError(
          InputFault::unknown_name,
          fmt::format("{}: parameter '{}' is unknown; known: lights, blocks, material, "
                      "kind, clamp, seed",
                      p.scene, p.name));
  }
  return cloud;
}

void refuse_parameters(const std::string& spec) {
  for (const Parameter& p : parameters_of(spec))
    throw InputError(
        InputFault::unknown_name,
        fmt::format("{}: parameter '{}' is unknown; the scene takes none", p.scene, p.name));
}

Scene make(const std::string& spec) {
  const std::string_view name = name_of(spec);
  if (name == "cloud") return make_cloud(cloud_of(spec));
  refuse_parameters(spec);
  return name == "bedroom" ? make_bedroom() : make_desk(name == "desk-red");
}

} // namespace

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes{
      {"desk", "a desk lit by its monitor: 24 x 9 white omni lights; some surfaces glossy"},
      {"desk-red", "the same; the lights on the screen's diagonal are red"},
      {"bedroom", "a furnished room lit by 100 coloured omni lights; some surfaces glossy"},
      {"cloud",
       fmt::format("a room of blocks under a cloud of lights: cloud?lights=10000&blocks=40"
                   "&material={}&kind={}&clamp=0.1&seed=1; glossy is phong; "
                   "default: no clamp",
                   fmt::join(materials_of_clouds(), "|"), fmt::join(kinds_of_clouds(), "|"))}};
  return scenes;
}

bool is_builtin(std::string_view spec) {
  return std::any_of(builtin_scenes().begin(), builtin_scenes().end(),
                     [&](const BuiltinScene& scene) { return scene.name == name_of(spec); });
}

Scene make_builtin(const std::string& spec) {
  if (!is_builtin(spec)) {
    std::string known;
    for (const BuiltinScene& scene : builtin_scenes())
      known += (known.empty() ? "" : ", ") + scene.name;
    throw InputError(InputFault::unknown_name,
                     fmt::format("unknown built-in scene '{}'; known: {}", name_of(spec), known));
  }
  Scene scene = make(spec);
  scene.name = spec;
  return scene;
}

} // namespace lightcuts
