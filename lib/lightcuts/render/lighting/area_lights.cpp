// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/area_lights.h>

#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/lighting/apportion.h>
#include <lightcuts/render/lighting/config_check.h>
#include <lightcuts/render/lighting/hammersley.h>
#include <lightcuts/render/lighting/textured_emitter.h>
#include <lightcuts/render/scene/append_lights.h>
#include <lightcuts/render/scene/triangle.h>
#include <lightcuts/render/view/directed_rounding.h>

namespace lightcuts {
namespace {

struct Emitters {
  std::vector<std::uint32_t> triangles;
  std::vector<double> powers;  ///< W
  std::size_t approximate = 0; ///< of those with textures
};

Emitters find_emitters(const Scene& scene) {
  Emitters found;
  for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const Surface& surface = scene.surfaces[scene.mesh.surface[i]];
    const glm::dvec3 radiance(surface.emission);
    if (radiance == glm::dvec3(0)) continue;
    glm::dvec3 intensity = Triangle(scene.mesh, i).area() * radiance;
    if (surface.emission_texture && mean(intensity) > 0) {
      const TexturedEmitter emitter(scene, i);
      intensity = emitter.intensity();
      found.approximate += emitter.is_approximate() ? 1 : 0;
    }
    const double power = std::numbers::pi * mean(intensity);
    if (!(power > 0)) continue; // without area, or where its texture is black
    found.triangles.push_back(i);
    found.powers.push_back(power);
  }
  return found;
}

void cover_textured(const Scene& scene, std::uint32_t index, std::uint32_t count,
                    std::uint64_t seed, LightSet& lights) {
  const Triangle triangle(scene.mesh, index);
  const glm::dvec3 normal = triangle.normal();
  for (const auto& sample : TexturedEmitter(scene, index).samples(count, Random(seed, index)))
    lights.add_oriented(rounded_towards(triangle.at(sample.barycentric), normal), glm::vec3(normal),
                        glm::vec3(sample.intensity));
}

void cover(const Scene& scene, std::uint32_t index, std::uint32_t count, std::uint64_t seed,
           LightSet& lights) {
  const Triangle triangle(scene.mesh, index);
  const glm::dvec3 normal = triangle.normal();
  const glm::dvec3 radiance(scene.surfaces[scene.mesh.surface[index]].emission);
  const glm::vec3 intensity(radiance * (triangle.area() / count));
  const Hammersley points(count, Random(seed, index));
  for (std::uint32_t k = 0; k < count; ++k) {
    const glm::dvec3 p = triangle.at(square_to_triangle(points[k]));
    lights.add_oriented(rounded_towards(p, normal), glm::vec3(normal), intensity);
  }
}

} // namespace

void add_area_lights(Scene& scene, const AreaLights& config) {
  require_within("area lights", "count", config.count, 1, AreaLights::max_count);
  const Emitters emitters = find_emitters(scene);
  if (emitters.triangles.empty())
    throw InputError(InputFault::missing, "area lights: no surface emits light");
  const std::vector<std::uint32_t> counts = apportion(emitters.powers, config.count);
  double power = 0;
  LightSet made; // so that a refusal adds none
  try {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const std::uint32_t t = emitters.triangles[i];
      const bool textured = scene.surfaces[scene.mesh.surface[t]].emission_texture.has_value();
      (textured ? cover_textured : cover)(scene, t, counts[i], config.seed, made);
      power += emitters.powers[i];
    }
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("area lights: {}", error.what()));
  }
  append(made, scene.lights);
  scene.notes.push_back(fmt::format("{} from {}, {:.4g} W", counted(made.size(), "area light"),
                                    counted(counts.size(), "triangle"), power));
  if (emitters.approximate > 0)
    scene.notes.push_back(
        counted(emitters.approximate, "triangle") +
        " with so many texels, or such a thin part of a texture, that its power was sampled");
}

} // namespace lightcuts
