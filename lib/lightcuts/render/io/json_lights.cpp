// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/json_lights.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/render/io/ies/ies_file.h>
#include <lightcuts/render/io/json_shapes.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/lighting/environment/environment_lights.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/light_kinds.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>

namespace lightcuts {
namespace {

/// Files of luminaires that a scene names, each read once.
class LuminaireFiles {
public:
  LuminaireFiles(const std::filesystem::path& folder, const FileAccess& access,
                 std::vector<std::string>& notes)
      : folder_(folder), access_(access), notes_(notes) {}

  const IesLuminaire& luminaire(const JsonElement& file) {
    const std::filesystem::path path = folder_ / file.path();
    access_.require(path, file.label());
    const auto [known, is_new] = read_.try_emplace(path);
    if (is_new) {
      try {
        known->second = load_ies(path);
      } catch (...) {
        read_.erase(known);
        throw;
      }
      notes_.insert(notes_.end(), known->second.notes.begin(), known->second.notes.end());
    }
    return known->second;
  }

private:
  const std::filesystem::path& folder_;
  const FileAccess& access_;
  std::vector<std::string>& notes_;
  std::map<std::filesystem::path, IesLuminaire> read_;
};

void add_single(const JsonElement& light, LightSet& lights, LuminaireFiles& files) {
  for (const char* generator :
       {"area", "cloud", "environment", "vpl", "surfels", "rectangle", "disc", "sphere", "tube"})
    if (light.has("type") && light["type"].is_string() && light["type"].string() == generator)
      light["type"].refuse(InputFault::unknown_name,
                           fmt::format("is '{0}', which is no light by itself: write \"generate\": "
                                       "\"{0}\" in place of \"type\"",
                                       generator));
  const auto kind =
      light.has("type") ? LightKind(light["type"].one_of(names_of(LightKind()))) : LightKind::omni;
  with_kind_in_scenes(kind, [&](auto described) {
    if constexpr (requires { described.read(light, lights, files); })
      described.read(light, lights, files);
    else
      described.read(light, lights);
  });
}

std::uint32_t count_of(const JsonElement& element, const char* key, std::uint32_t most) {
  return static_cast<std::uint32_t>(element[key].whole_number(1, most));
}

std::uint64_t seed_of(const JsonElement& element) {
  return element.has("seed") ? element["seed"].whole_number(0, UINT64_MAX) : 1;
}

void set_box(const JsonElement& box, LightCloud& cloud) {
  if (!box.is_list() || box.size() != 2)
    box.refuse(InputFault::malformed_file, "is not a list of two corners");
  cloud.lo = box.at(0).vector();
  cloud.hi = box.at(1).vector();
  for (int axis = 0; axis < 3; ++axis)
    if (cloud.lo[axis] > cloud.hi[axis])
      box.at(0).refuse(InputFault::inconsistent,
                       fmt::format("exceeds the other corner in {}", "xyz"[axis]));
}

void add_cloud(const JsonElement& element, Scene& scene) {
  LightCloud cloud = default_cloud(scene.mesh, count_of(element, "count", LightCloud::max_count),
                                   seed_of(element));
  if (element.has("box")) set_box(element["box"], cloud);
  if (element.has("intensity")) cloud.intensity = element["intensity"].colour();
  generate(cloud, scene.lights);
}

void add_area(const JsonElement& element, Scene& scene) {
  element.expect_keys({"generate", "count", "seed"});
  add_area_lights(scene, {.count = count_of(element, "count", AreaLights::max_count),
                          .seed = seed_of(element)});
}

void add_environment(const JsonElement& element, const std::filesystem::path& folder,
                     const FileAccess& access, Scene& scene) {
  element.expect_keys({"generate", "file", "count", "turn", "visible"});
  EnvironmentLights config;
  if (element.has("turn")) config.turn = element["turn"].wide_number();
  if (element.has("visible")) config.visible = element["visible"].boolean();
  if (element.has("count")) config.count = count_of(element, "count", EnvironmentLights::max_count);
  const std::filesystem::path file = folder / element["file"].path();
  access.require(file, element["file"].label());
  add_environment_lights(scene, read_environment(file), config);
}

void add_vpls(const JsonElement& element, Scene& scene) {
  element.expect_keys({"generate", "paths", "bounces", "seed"});
  VirtualPointLights config;
  config.paths = count_of(element, "paths", VirtualPointLights::max_paths);
  if (element.has("bounces"))
    config.bounces = count_of(element, "bounces", VirtualPointLights::max_bounces);
  config.seed = seed_of(element);
  add_virtual_point_lights(scene, config);
}

void add_surfel_lights(const JsonElement& element, Scene& scene) {
  element.expect_keys({"generate", "count", "seed"});
  add_surfels(scene,
              {.count = count_of(element, "count", Surfels::max_count), .seed = seed_of(element)});
}

void add_generated(const JsonElement& element, const std::filesystem::path& folder,
                   const FileAccess& access, Scene& scene) {
  const std::string kind = element["generate"].string();
  if (kind == "cloud") {
    element.expect_keys({"generate", "count", "seed", "box", "intensity"});
    return add_cloud(element, scene);
  }
  if (kind == "area") return add_area(element, scene);
  if (kind == "environment") return add_environment(element, folder, access, scene);
  if (kind == "vpl") return add_vpls(element, scene);
  if (kind == "surfels") return add_surfel_lights(element, scene);
  if (const auto shape = value_named<ShapeKind>(kind))
    return add_shape_lights(scene, read_shape(element, *shape));
  element["generate"].refuse(
      InputFault::unknown_name,
      fmt::format(
          "is '{}', expected 'cloud', 'area', 'environment', 'vpl', 'surfels', 'rectangle', "
          "'disc', 'sphere' or 'tube'",
          kind));
}

/// A name that channels of images can have.
std::string group_in(const JsonElement& element) {
  constexpr std::size_t longest = 64;
  const std::string name = element.string();
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '-' || c == '_' || c == ' ');
  });
  if (!plain || name.empty() || name.size() > longest)
    element.refuse(InputFault::malformed_file,
                   "is not a name of up to 64 letters, digits, '-', '_' and blanks");
  if (name == "others")
    element.refuse(InputFault::malformed_file, "is 'others', which is what has no group");
  return name;
}

/// The lights from `first` on.
void add_to_group(Scene& scene, const std::string& name, std::size_t first) {
  const std::size_t count = scene.lights.size() - first;
  if (!scene.groups.empty() && scene.groups.back().name == name &&
      scene.groups.back().first + scene.groups.back().count == first)
    scene.groups.back().count += count;
  else
    scene.groups.push_back({name, first, count});
}

/// Errors of what the element asks for, which do not know of it, get its name.
template <class Action>
void naming(const JsonElement& element, const Action& action) {
  try {
    action();
  } catch (const JsonError&) {
    throw;
  } catch (const InputError& error) {
    element.refuse_as(error.fault(), fmt::format(": {}", error.what()));
  }
}

} // namespace

void add_lights(const JsonElement& lights, const std::filesystem::path& folder,
                const FileAccess& access, Scene& scene) {
  if (!lights.is_list()) {
    lights.expect_keys({"count", "seed", "box", "intensity"});
    return naming(lights, [&] { add_cloud(lights, scene); });
  }
  LuminaireFiles files(folder, access, scene.notes);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    nlohmann::json without_group;
    const JsonElement whole = lights.at(i);
    const bool grouped = whole.has("group");
    const std::string group = grouped ? group_in(whole["group"]) : "";
    const JsonElement light = grouped ? whole.without("group", without_group) : whole;
    const std::size_t first = scene.lights.size();
    naming(light, [&] {
      if (light.has("generate")) return add_generated(light, folder, access, scene);
      add_single(light, scene.lights, files);
    });
    if (grouped) add_to_group(scene, group, first);
  }
}

} // namespace lightcuts
