// SPDX-License-Identifier: MIT
#include <lightcuts/render/builtin_scenes.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>
#include <lightcuts/input_error.h>
#include <lightcuts/render/light_generator.h>

#include "builtin_makers.h"

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
      throw InputError(fmt::format("{}: parameter '{}' has no value", scene, item));
    const std::string name = item.substr(0, equals);
    for (const Parameter& earlier : parameters)
      if (earlier.name == name)
        throw InputError(fmt::format("{}: parameter '{}' is given twice", scene, name));
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
    throw InputError(fmt::format("{}: parameter '{}' is '{}', expected a whole number", p.scene,
                                 p.name, p.value));
  if (error != std::errc{} || number < least || number > most)
    throw InputError(fmt::format("{}: parameter '{}' is {}, expected {} to {}", p.scene, p.name,
                                 p.value, least, most));
  return number;
}

bool is_glossy(const Parameter& p) {
  if (p.value != "diffuse" && p.value != "glossy")
    throw InputError(fmt::format("{}: parameter '{}' is '{}', expected diffuse or glossy", p.scene,
                                 p.name, p.value));
  return p.value == "glossy";
}

CloudScene cloud_of(const std::string& spec) {
  CloudScene cloud;
  for (const Parameter& p : parameters_of(spec)) {
    if (p.name == "lights")
      cloud.lights = static_cast<std::uint32_t>(whole_number(p, 1, LightCloud::max_count));
    else if (p.name == "blocks")
      cloud.blocks = static_cast<std::uint32_t>(whole_number(p, 0, CloudScene::max_blocks));
    else if (p.name == "material")
      cloud.glossy = is_glossy(p);
    else if (p.name == "seed")
      cloud.seed = whole_number(p, 0, std::numeric_limits<std::uint64_t>::max());
    else
      throw InputError(fmt::format(
          "{}: parameter '{}' is unknown; known: lights, blocks, material, seed", p.scene, p.name));
  }
  return cloud;
}

void refuse_parameters(const std::string& spec) {
  for (const Parameter& p : parameters_of(spec))
    throw InputError(
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
      {"cloud", "a room of blocks under a cloud of omni lights: "
                "cloud?lights=10000&blocks=40&material=diffuse|glossy&seed=1"}};
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
    throw InputError(fmt::format("unknown built-in scene '{}'; known: {}", name_of(spec), known));
  }
  Scene scene = make(spec);
  scene.name = spec;
  return scene;
}

} // namespace lightcuts
