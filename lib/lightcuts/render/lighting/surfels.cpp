// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/surfels.h>

#include <array>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/core/cut/sum_lights.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/lighting/min_distance.h>
#include <lightcuts/render/view/scene_view.h>
#include <lightcuts/render/view/surface_material.h>
#include <lightcuts/render/view/surface_point.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/lighting/apportion.h>
#include <lightcuts/render/lighting/config_check.h>
#include <lightcuts/render/lighting/hammersley.h>
#include <lightcuts/render/scene/append_lights.h>
#include <lightcuts/render/scene/triangle.h>
#include <lightcuts/render/view/directed_rounding.h>

namespace lightcuts {
namespace {

struct Surfel {
  Hit hit;
  std::array<glm::dvec3, 2> radiance; ///< reflected in front and behind
};

std::vector<Surfel> scatter(const TriangleMesh& mesh, const std::vector<double>& areas,
                            const Surfels& config) {
  // Generator 0 shares the points out, those that follow are the triangles'.
  const auto counts = draw_stratified(areas, config.count, Random(config.seed, 0));
  std::vector<Surfel> surfels;
  surfels.reserve(config.count);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (counts[i] == 0) continue;
    const Hammersley points(counts[i], Random(config.seed, i + std::uint64_t{1}));
    for (std::uint32_t k = 0; k < counts[i]; ++k)
      surfels.push_back({{i, square_to_triangle(points[k]), 0}, {}});
  }
  return surfels;
}

/// What a side of a surfel reflects of the light that reaches it directly.
glm::dvec3 gather(const SceneView& view, const Hit& hit, double side) {
  const Scene& scene = view.scene();
  const glm::vec3 looking(-side * Triangle(scene.mesh, hit.triangle).normal());
  const SurfacePoint at = surface_point(scene.mesh, hit, looking);
  const Material diffuse{.diffuse = material_at(scene, hit).diffuse, .lobe = {}};
  const VisiblePoint from{
      ShadingPoint(at.position, at.geometric_normal, at.geometric_normal, diffuse), at.ray_origin,
      glm::vec3(0)};
  return sum_lights(scene.lights, from.point,
                    [&](std::uint32_t light) { return view.sees(from, light); })
      .radiance;
}

void light_up(const Scene& scene, unsigned threads, std::vector<Surfel>& surfels) {
  const SceneView view(scene);
  const auto light_one = [&](std::size_t i) {
    surfels[i].radiance = {gather(view, surfels[i].hit, 1), gather(view, surfels[i].hit, -1)};
  };
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, surfels.size(), light_one); });
}

LightSet lights_of(const TriangleMesh& mesh, const std::vector<Surfel>& surfels, double area) {
  LightSet lights;
  for (const Surfel& surfel : surfels) {
    const Triangle triangle(mesh, surfel.hit.triangle);
    const glm::dvec3 position = triangle.at(surfel.hit.barycentric);
    for (const int side : {0, 1}) {
      const glm::dvec3& radiance = surfel.radiance[side];
      if (radiance == glm::dvec3(0)) continue;
      const glm::dvec3 normal = (side == 0 ? 1.0 : -1.0) * triangle.normal();
      lights.add_oriented(rounded_towards(position, normal), glm::vec3(normal),
                          glm::vec3(radiance * area));
    }
  }
  return lights;
}

} // namespace

void add_surfels(Scene& scene, const Surfels& config) {
  require_within("surfels", "count", config.count, 1, Surfels::max_count);
  if (scene.lights.empty()) throw InputError(InputFault::missing, "surfels: no light to reflect");
  std::vector<double> areas;
  for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i)
    areas.push_back(Triangle(scene.mesh, i).area());
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (!(total > 0)) throw InputError(InputFault::missing, "surfels: no triangle has an area");

  std::vector<Surfel> surfels = scatter(scene.mesh, areas, config);
  light_up(scene, config.threads, surfels);
  LightSet made; // so that a refusal adds none
  try {
    made = lights_of(scene.mesh, surfels, total / config.count);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("surfels: {}", error.what()));
  }
  append(made, scene.lights);

  glm::dvec3 power(0);
  for (const Light& light : made) power += std::numbers::pi * glm::dvec3(light.intensity);
  scene.notes.push_back(fmt::format(
      "{} from {} of {:.4g} m^2, {:.4g} W; for a min_distance consider {:.3g}",
      counted(made.size(), "light"), counted(surfels.size(), "surfel"), total / config.count,
      mean(power), suggested_min_distance(scene.mesh, surfels.size())));
}

} // namespace lightcuts
