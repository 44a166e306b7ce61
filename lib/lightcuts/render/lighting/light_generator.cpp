// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/light_generator.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/bounds.h>

#include <lightcuts/render/lighting/random.h>

namespace lightcuts {
namespace {

// Irradiance of a total intensity I seen from a quarter of the diagonal d is 16 I/d^2; with a
// reflectance of 0.6 that makes a radiance of about 3 I/d^2, less the cosine.
constexpr double intensity_per_squared_diagonal = 0.3;
constexpr float cloud_margin = 0.05F;

[[noreturn]] void refuse(InputFault fault, const char* field, int axis, const char* axes,
                         float value, const char* why) {
  throw InputError(fault,
                   fmt::format("light cloud: {}.{} is {}, {}", field, axes[axis], value, why));
}

void validate(const LightCloud& cloud) {
  if (cloud.count < 1 || cloud.count > LightCloud::max_count)
    throw InputError(InputFault::out_of_domain,
                     fmt::format("light cloud: count is {}, expected 1 to {}", cloud.count,
                                 LightCloud::max_count));
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(cloud.lo[i]))
      refuse(InputFault::not_finite, "lo", i, "xyz", cloud.lo[i], "not a finite number");
    if (!std::isfinite(cloud.hi[i]))
      refuse(InputFault::not_finite, "hi", i, "xyz", cloud.hi[i], "not a finite number");
    if (cloud.lo[i] > cloud.hi[i])
      refuse(InputFault::inconsistent, "lo", i, "xyz", cloud.lo[i], "greater than hi");
    const float intensity = cloud.intensity[i];
    if (!std::isfinite(intensity))
      refuse(InputFault::not_finite, "intensity", i, "rgb", intensity, "not a finite number");
    if (intensity < 0) refuse(InputFault::negative, "intensity", i, "rgb", intensity, "negative");
  }
}

struct Draw {
  glm::vec3 position;
  glm::dvec3 weight;
};

Draw draw(const LightCloud& cloud, std::uint32_t index) {
  Random random(cloud.seed, index);
  Draw result{};
  for (int axis = 0; axis < 3; ++axis)
    result.position[axis] = random.between(cloud.lo[axis], cloud.hi[axis]);
  result.weight = glm::dvec3(random.between(0.5F, 1.5F));
  if (cloud.random_colours)
    for (int c = 0; c < 3; ++c) result.weight[c] *= static_cast<double>(random.between(0.2F, 1));
  return result;
}

} // namespace

void generate(const LightCloud& cloud, LightSet& lights) {
  validate(cloud);
  glm::dvec3 sum{0};
  for (std::uint32_t i = 0; i < cloud.count; ++i) sum += draw(cloud, i).weight;
  lights.reserve(lights.size() + cloud.count);
  for (std::uint32_t i = 0; i < cloud.count; ++i) {
    const Draw light = draw(cloud, i);
    lights.add_omni(light.position, glm::vec3(glm::dvec3(cloud.intensity) * (light.weight / sum)));
  }
}

LightCloud default_cloud(const TriangleMesh& mesh, std::uint32_t count, std::uint64_t seed) {
  if (mesh.triangles.empty())
    throw InputError(InputFault::missing, "light cloud: the scene has no triangles");
  const Box box = scene_bounds(mesh);
  const glm::vec3 extent = 0.5F * box.hi - 0.5F * box.lo; // halves: cannot overflow
  const double diagonal = diagonal_length(box);
  const double intensity = intensity_per_squared_diagonal * diagonal * diagonal;
  LightCloud cloud;
  cloud.count = count;
  cloud.seed = seed;
  cloud.lo = box.lo + 2 * cloud_margin * extent;
  cloud.lo.y = 0.5F * box.lo.y + 0.5F * box.hi.y;
  cloud.hi = box.hi - 2 * cloud_margin * extent;
  // Above a flat scene, not in it: lights in the plane of a surface do not light it.
  if (extent.y <= 1e-3 * diagonal)
    cloud.lo.y = cloud.hi.y = static_cast<float>(double(box.hi.y) + 0.25 * diagonal);
  // A flat box can lose the order to rounding.
  for (int axis = 0; axis < 3; ++axis) cloud.hi[axis] = std::max(cloud.lo[axis], cloud.hi[axis]);
  cloud.intensity = glm::vec3(static_cast<float>(std::min(intensity, 1e38)));
  return cloud;
}

} // namespace lightcuts
