// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/virtual_point_lights.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/lighting/min_distance.h>
#include <lightcuts/render/view/occluder.h>
#include <lightcuts/render/view/surface_material.h>
#include <lightcuts/render/view/surface_point.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/lighting/apportion.h>
#include <lightcuts/render/lighting/config_check.h>
#include <lightcuts/render/lighting/direction_sampling.h>
#include <lightcuts/render/lighting/hammersley.h>
#include <lightcuts/render/lighting/light_emission.h>
#include <lightcuts/render/scene/append_lights.h>
#include <lightcuts/render/scene/triangle.h>
#include <lightcuts/render/view/directed_rounding.h>

namespace lightcuts {
namespace {

class Tracer {
public:
  Tracer(const Scene& scene, std::uint32_t bounces)
      : scene_(scene), occluder_(scene.mesh), bounces_(bounces) {}

  void trace(LightRay ray, glm::dvec3 flux, Random& random) {
    for (std::uint32_t bounce = 0; bounce < bounces_; ++bounce) {
      const glm::vec3 direction(ray.direction);
      const auto hit = occluder_.intersect(ray.origin, direction);
      if (!hit) return;
      const SurfacePoint point = surface_point(scene_.mesh, *hit, direction);
      const glm::dvec3 normal(glm::normalize(glm::dvec3(point.geometric_normal)));
      const glm::dvec3 reflected = flux * glm::dvec3(material_at(scene_, *hit).diffuse);
      if (!(largest(reflected) > 0)) return;
      add_light(Triangle(scene_.mesh, hit->triangle).at(hit->barycentric), normal, reflected);
      const double survival = std::min(1.0, largest(reflected) / largest(flux));
      if (random.unit_double() >= survival) return;
      flux = reflected / survival;
      const double y = random.unit_double(), x = random.unit_double();
      ray = {point.ray_origin, square_to_cosine(normal, {x, y})};
    }
  }

  [[nodiscard]] const LightSet& lights() const { return lights_; }
  [[nodiscard]] const glm::dvec3& power() const { return power_; }

private:
  void add_light(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& power) {
    lights_.add_oriented(rounded_towards(position, normal), glm::vec3(normal),
                         glm::vec3(power * std::numbers::inv_pi));
    power_ += power;
  }

  const Scene& scene_;
  Occluder occluder_;
  std::uint32_t bounces_;
  LightSet lights_;
  glm::dvec3 power_{0}; // of the lights, W
};

void trace_all(const Scene& scene, const VirtualPointLights& config, Tracer& tracer) {
  const LightEmission emission(scene.mesh);
  std::vector<double> powers; // by which paths are shared out
  double total = 0;
  for (const Light& light : scene.lights) {
    powers.push_back(mean(emission.power(light)));
    total += powers.back();
  }
  if (!(total > 0)) throw InputError(InputFault::missing, "no light to start from");

  // The generators of even numbers share out, those of odd ones are the paths'.
  const auto counts = draw_stratified(powers, config.paths, Random(config.seed, 0));
  std::uint64_t path = 0;
  for (std::uint32_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const Light& light = scene.lights[i];
    const Hammersley points(counts[i], Random(config.seed, 2 * (i + std::uint64_t{1})));
    const glm::dvec3 flux = emission.power(light) * (total / powers[i] / config.paths);
    for (std::uint32_t k = 0; k < counts[i]; ++k) {
      Random random(config.seed, 2 * path++ + 1);
      const LightRay ray = emission.ray(light, points[k], random);
      tracer.trace(ray, flux, random);
    }
  }
}

} // namespace

void add_virtual_point_lights(Scene& scene, const VirtualPointLights& config) {
  require_within("VPLs", "paths", config.paths, 1, VirtualPointLights::max_paths);
  require_within("VPLs", "bounces", config.bounces, 1, VirtualPointLights::max_bounces);
  Tracer tracer(scene, config.bounces);
  try {
    trace_all(scene, config, tracer);
  } catch (const InputError& error) {
    throw InputError(error.fault(), fmt::format("VPLs: {}", error.what()));
  }
  append(tracer.lights(), scene.lights);
  std::string note = fmt::format("{} from {}, {:.4g} W", counted(tracer.lights().size(), "VPL"),
                                 counted(config.paths, "light path"), mean(tracer.power()));
  if (!tracer.lights().empty())
    note += fmt::format("; for a min_distance consider {:.3g}",
                        suggested_min_distance(scene.mesh, tracer.lights().size()));
  scene.notes.push_back(note);
}

} // namespace lightcuts
