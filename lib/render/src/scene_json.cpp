// SPDX-License-Identifier: MIT
#include <lightcuts/render/scene_json.h>

#include <fmt/format.h>
#include <lightcuts/input_error.h>
#include <lightcuts/render/light_generator.h>
#include <lightcuts/render/model_import.h>
#include <lightcuts/render/open_scene.h>

#include "camera_fault.h"
#include "json_element.h"
#include "json_text.h"
#include "text.h"

namespace lightcuts {
namespace {

glm::vec3 intensity_of(const JsonElement& element) {
  if (element.is_number()) return glm::vec3(element.number(0));
  return element.vector(0);
}

void load_geometry(const JsonElement& element, const std::filesystem::path& folder, Scene& scene,
                   bool& has_camera) {
  const auto append = [&](const JsonElement& name) {
    const Camera before = scene.camera;
    const bool found = append_model(folder / name.string(), scene);
    if (has_camera) scene.camera = before; // the first one stays
    has_camera = has_camera || found;
  };
  if (!element.is_list()) return append(element);
  if (element.size() == 0) element.refuse("is empty");
  for (std::size_t i = 0; i < element.size(); ++i) append(element.at(i));
}

Camera camera_of(const JsonElement& element) {
  element.expect_keys({"position", "target", "up", "fov"});
  Camera camera;
  camera.position = element["position"].vector();
  camera.target = element["target"].vector();
  if (element.has("up")) camera.up = element["up"].vector();
  if (element.has("fov")) camera.vertical_fov = element["fov"].number();
  const std::string fault = camera_fault(camera);
  if (!fault.empty()) element.refuse_as("/" + fault);
  return camera;
}

glm::uvec2 image_size_of(const JsonElement& element) {
  element.expect_keys({"width", "height"});
  return {element["width"].whole_number(1, max_image_side),
          element["height"].whole_number(1, max_image_side)};
}

void add_listed(const JsonElement& list, LightSet& lights) {
  lights.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonElement light = list.at(i);
    light.expect_keys({"position", "intensity"});
    lights.add_omni(light["position"].vector(), intensity_of(light["intensity"]));
  }
}

void set_box(const JsonElement& box, LightCloud& cloud) {
  if (!box.is_list() || box.size() != 2) box.refuse("is not a list of two corners");
  cloud.lo = box.at(0).vector();
  cloud.hi = box.at(1).vector();
  for (int axis = 0; axis < 3; ++axis)
    if (cloud.lo[axis] > cloud.hi[axis])
      box.at(0).refuse(fmt::format("exceeds the other corner in {}", "xyz"[axis]));
}

void add_generated(const JsonElement& element, const TriangleMesh& mesh, LightSet& lights) {
  element.expect_keys({"count", "seed", "box", "intensity"});
  const auto count =
      static_cast<std::uint32_t>(element["count"].whole_number(1, LightCloud::max_count));
  const std::uint64_t seed = element.has("seed") ? element["seed"].whole_number(0, UINT64_MAX) : 1;
  LightCloud cloud = default_cloud(mesh, count, seed);
  if (element.has("box")) set_box(element["box"], cloud);
  if (element.has("intensity")) cloud.intensity = intensity_of(element["intensity"]);
  generate(cloud, lights);
}

void replace_lights(const JsonElement& element, Scene& scene) {
  scene.lights = LightSet();
  if (element.is_list()) return add_listed(element, scene.lights);
  add_generated(element, scene.mesh, scene.lights);
}

} // namespace

Scene load_scene_json(const std::filesystem::path& file) {
  const std::string name = file.string();
  const nlohmann::json json = parse_json(name, read_file(file));
  const JsonElement root(name, json);
  root.expect_keys({"geometry", "camera", "image", "lights"});
  Scene scene;
  scene.name = file.stem().string();
  bool has_camera = root.has("camera");
  if (has_camera) scene.camera = camera_of(root["camera"]);
  if (root.has("image")) scene.image_size = image_size_of(root["image"]);
  load_geometry(root["geometry"], file.parent_path(), scene, has_camera);
  if (!has_camera) {
    scene.camera = framing(scene.mesh);
    scene.notes.push_back(fmt::format("{}: no camera: framed", name));
  }
  if (root.has("lights")) replace_lights(root["lights"], scene);
  return scene;
}

} // namespace lightcuts
