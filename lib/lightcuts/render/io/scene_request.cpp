// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/scene_request.h>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/lighting/area_lights.h>
#include <lightcuts/render/lighting/environment/environment_lights.h>
#include <lightcuts/render/lighting/light_generator.h>
#include <lightcuts/render/lighting/surfels.h>
#include <lightcuts/render/lighting/virtual_point_lights.h>
#include <lightcuts/render/scene/camera_fault.h>

namespace lightcuts {
namespace {

/// The scene's own lights give way to a cloud; where they are clamped stays.
void replace_lights(const SceneRequest& request, Scene& scene) {
  const float min_distance = scene.lights.min_distance();
  scene.lights = LightSet();
  scene.groups.clear();
  if (min_distance > 0) scene.lights.set_min_distance(min_distance);
  generate(default_cloud(scene.mesh, request.lights, request.seed), scene.lights);
}

void set_camera(const CameraRequest& request, Camera& camera) {
  camera.position = request.position;
  camera.target = request.target;
  if (request.vertical_fov) camera.vertical_fov = *request.vertical_fov;
  // Straight down, say, another direction has to be up.
  for (const glm::vec3& up : {camera.up, glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)}) {
    camera.up = up;
    const auto fault = camera_fault(camera);
    if (!fault) return;
    if (!fault->what.starts_with("up")) throw InputError(fault->cause, "camera: " + fault->what);
  }
}

void make_lights(const SceneRequest& request, unsigned threads, Scene& scene) {
  if (request.lights > 0) replace_lights(request, scene);
  if (request.min_distance) scene.lights.set_min_distance(*request.min_distance);
  if (request.area_lights > 0)
    add_area_lights(scene, {.count = request.area_lights, .seed = request.seed});
  if (!request.environment.empty())
    add_environment_lights(scene, read_environment(request.environment),
                           {.turn = request.environment_turn,
                            .visible = request.environment_visible,
                            .count = request.environment_lights});
  if (request.vpls > 0)
    add_virtual_point_lights(scene, {.paths = request.vpls, .seed = request.seed});
  if (request.surfels > 0)
    add_surfels(scene, {.count = request.surfels, .seed = request.seed, .threads = threads});
}

} // namespace

Scene open_scene(const SceneRequest& request, unsigned threads, const Progress& progress) {
  Scene scene = open_scene(request.spec, request.allow_outside);
  progress.leave_if_cancelled();
  if (request.image_size) scene.image_size = *request.image_size;
  try {
    if (request.camera) set_camera(*request.camera, scene.camera);
    make_lights(request, threads, scene);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("{}: {}", request.spec, error.what()));
  }
  validate(scene);
  return scene;
}

} // namespace lightcuts
