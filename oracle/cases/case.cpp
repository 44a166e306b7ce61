// SPDX-License-Identifier: MIT
#include <oracle/cases/case.h>

namespace lightcuts::oracle {

LightSet Case::light_set() const {
  LightSet set;
  for (const Light& light : lights) set.add(light);
  if (min_distance > 0) set.set_min_distance(min_distance);
  return set;
}

lightcuts::Scene Case::scene() const {
  lightcuts::Scene scene;
  scene.name = "case";
  scene.lights = light_set();
  scene.camera = camera;
  scene.image_size = image_size;
  for (const CaseTriangle& t : triangles) {
    const auto first = std::uint32_t(scene.mesh.positions.size());
    scene.mesh.positions.insert(scene.mesh.positions.end(), {t.a, t.b, t.c});
    scene.mesh.triangles.emplace_back(first, first + 1, first + 2);
    scene.mesh.surface.push_back(t.mesh);
    while (scene.surfaces.size() <= t.mesh)
      scene.surfaces.push_back({"", views.empty() ? Material{} : views.front().view.material});
  }
  scene.mesh.normals.resize(scene.mesh.positions.size(), glm::vec3(0));
  return scene;
}

} // namespace lightcuts::oracle
