// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/scene_json.h>

#include <fmt/format.h>
#include <lightcuts/render/io/models/model_import.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/json/json_element.h>
#include <lightcuts/render/io/json/json_text.h>
#include <lightcuts/render/io/json_lights.h>
#include <lightcuts/render/scene/camera_fault.h>
#include <lightcuts/render/scene/framing.h>

namespace lightcuts {
namespace {

void load_geometry(const JsonElement& element, const std::filesystem::path& folder,
                   const FileAccess& access, Scene& scene, bool& has_camera) {
  const auto append = [&](const JsonElement& name) {
    const Camera before = scene.camera;
    const std::filesystem::path file = folder / name.path();
    access.require(file, name.label());
    const bool found = append_model(file, access, scene);
    if (has_camera) scene.camera = before; // the first one stays
    has_camera = has_camera || found;
  };
  if (!element.is_list()) return append(element);
  if (element.size() == 0) element.refuse(InputFault::missing, "is empty");
  for (std::size_t i = 0; i < element.size(); ++i) append(element.at(i));
}

Camera camera_of(const JsonElement& element) {
  element.expect_keys({"position", "target", "up", "fov"});
  Camera camera;
  camera.position = element["position"].vector();
  camera.target = element["target"].vector();
  if (element.has("up")) camera.up = element["up"].vector();
  if (element.has("fov")) camera.vertical_fov = element["fov"].number();
  if (const auto fault = camera_fault(camera)) element.refuse_as(fault->cause, "/" + fault->what);
  return camera;
}

glm::uvec2 image_size_of(const JsonElement& element) {
  element.expect_keys({"width", "height"});
  return {element["width"].whole_number(1, max_image_side),
          element["height"].whole_number(1, max_image_side)};
}

/// Before lights are generated, some of which depend on it.
void set_min_distance(const JsonElement& element, LightSet& lights) {
  const float distance = element.number();
  if (!(distance > 0))
    element.refuse(fault_of(distance), fmt::format("is {}, expected more than 0", distance));
  lights.set_min_distance(distance);
}

} // namespace

Scene load_scene_json(const std::filesystem::path& file, const FileAccess& access) {
  const std::string name = file.string();
  const nlohmann::json json = parse_json(name, read_text(file));
  const JsonElement root(name, json);
  root.expect_keys({"geometry", "camera", "image", "lights", "min_distance"});
  Scene scene;
  scene.name = file.stem().string();
  bool has_camera = root.has("camera");
  if (has_camera) scene.camera = camera_of(root["camera"]);
  if (root.has("image")) scene.image_size = image_size_of(root["image"]);
  load_geometry(root["geometry"], file.parent_path(), access, scene, has_camera);
  if (!has_camera) {
    scene.camera = framing(scene.mesh);
    scene.notes.push_back(fmt::format("{}: no camera: framed", name));
  }
  if (root.has("lights")) scene.lights = LightSet();
  if (root.has("min_distance")) set_min_distance(root["min_distance"], scene.lights);
  if (root.has("lights")) add_lights(root["lights"], file.parent_path(), access, scene);
  return scene;
}

} // namespace lightcuts
