// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/json_lights.h>

#include <string>

#include <fmt/format.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/lighting/environment/environment_lights.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/light_kinds.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>

namespace lightcuts {
namespace {

void add_single(const JsonElement& light, LightSet& lights) {
  for (const char* generator : {"area", "cloud", "environment", "vpl", "surfels"})
    if (light.has("type") && light["type"].is_string() && light["type"].string() == generator)
      light["type"].refuse(InputFault::unknown_name,
                           fmt::format("is '{0}', which is no light by itself: write \"generate\": "
                                       "\"{0}\" in place of \"type\"",
                                       generator));
  const auto kind =
      light.has("type") ? LightKind(light["type"].one_of(names_of(LightKind()))) : LightKind::omni;
  with_kind_in_scenes(kind, [&](auto described) { described.read(light, lights); });
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
  element.expect_keys({"generate", "file", "count"});
  EnvironmentLights config;
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
  element["generate"].refuse(
      InputFault::unknown_name,
      fmt::format("is '{}', expected 'cloud', 'area', 'environment', 'vpl' or 'surfels'", kind));
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
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const JsonElement light = lights.at(i);
    naming(light, [&] {
      if (light.has("generate")) return add_generated(light, folder, access, scene);
      add_single(light, scene.lights);
    });
  }
}

} // namespace lightcuts
