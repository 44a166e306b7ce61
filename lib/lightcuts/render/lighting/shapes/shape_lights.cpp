// SPDX-License-Identifier: MIT
#include <lightcuts/render/lighting/shapes/shape_lights.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/numerics/number_text.h>
#include <lightcuts/core/numerics/rounding.h>
#include <lightcuts/core/records/fields.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/channels.h>
#include <lightcuts/render/lighting/config_check.h>
#include <lightcuts/render/lighting/direction_sampling.h>
#include <lightcuts/render/lighting/hammersley.h>
#include <lightcuts/render/scene/append_lights.h>

namespace lightcuts {
namespace {

struct SurfacePlace {
  glm::dvec3 position, normal;
};

/// A map from the unit square to the shape that keeps areas, but for a factor.
SurfacePlace place_on(const ShapeLights& shape, const glm::dvec2& u) {
  const glm::dvec3 centre(shape.centre), axis = glm::normalize(glm::dvec3(shape.axis));
  switch (shape.kind) {
  case ShapeKind::rectangle: {
    const glm::dvec3 across = glm::normalize(glm::cross(axis, glm::dvec3(shape.along)));
    const glm::dvec3 along = glm::cross(across, axis);
    return {centre + (u.x - 0.5) * double(shape.sides.x) * along +
                (u.y - 0.5) * double(shape.sides.y) * across,
            axis};
  }
  case ShapeKind::disc:
    return {centre + about(axis, shape.radius * std::sqrt(u.x), u.y), axis};
  case ShapeKind::sphere: {
    const glm::dvec3 normal = at_cosine(axis, 1 - 2 * u.x, u.y); // Archimedes' hat box
    return {centre + double(shape.radius) * normal, normal};
  }
  default: {
    const glm::dvec3 normal = about(axis, 1, u.y);
    return {centre + (u.x - 0.5) * double(shape.length) * axis + double(shape.radius) * normal,
            normal};
  }
  }
}

void require_size(const ShapeLights& shape, const char* field, float value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(fault_of(value),
                     fmt::format("{} light: {} is {}, expected a finite number above 0",
                                 name_of(shape.kind), field, number_text(value)));
}

void require_valid(const ShapeLights& shape) {
  require_within("shape lights", "count", shape.count, 1, ShapeLights::max_count);
  if (shape.kind == ShapeKind::rectangle) {
    require_size(shape, "width", shape.sides.x);
    require_size(shape, "height", shape.sides.y);
    const glm::dvec3 across = glm::cross(glm::dvec3(shape.axis), glm::dvec3(shape.along));
    if (!(glm::length(across) > 1e-3))
      throw InputError(InputFault::inconsistent,
                       "rectangle light: along is parallel to the normal");
  } else {
    require_size(shape, "radius", shape.radius);
  }
  if (shape.kind == ShapeKind::tube) require_size(shape, "length", shape.length);
  for (int c = 0; c < 3; ++c)
    if (!(shape.radiance[c] >= 0) || !std::isfinite(shape.radiance[c]))
      throw InputError(fault_of(shape.radiance[c]),
                       fmt::format("{} light: radiance.{} is {}, expected 0 or more",
                                   name_of(shape.kind), "rgb"[c], number_text(shape.radiance[c])));
}

} // namespace

double area_of(const ShapeLights& shape) {
  const double r = shape.radius, pi = std::numbers::pi;
  switch (shape.kind) {
  case ShapeKind::rectangle:
    return double(shape.sides.x) * shape.sides.y;
  case ShapeKind::disc:
    return pi * r * r;
  case ShapeKind::sphere:
    return 4 * pi * r * r;
  default:
    return 2 * pi * r * shape.length;
  }
}

void add_shape_lights(Scene& scene, const ShapeLights& shape) {
  require_valid(shape);
  const glm::dvec3 total = area_of(shape) * glm::dvec3(shape.radiance);
  const Hammersley points(shape.count, Random(shape.seed));
  LightSet made; // so that a refusal adds none
  made.reserve(shape.count);
  glm::dvec3 left = total;
  for (std::uint32_t i = 0; i < shape.count; ++i) {
    const SurfacePlace place = place_on(shape, points[i]);
    glm::vec3 intensity;
    for (int c = 0; c < 3; ++c) intensity[c] = to_float(std::max(0.0, left[c] / (shape.count - i)));
    left -= glm::dvec3(intensity);
    made.add_oriented(glm::vec3(place.position), glm::vec3(place.normal), intensity);
  }
  append(made, scene.lights);
  scene.notes.push_back(fmt::format("{} on a {} of {:.4g} m^2, {:.4g} W",
                                    counted(made.size(), "oriented light"), name_of(shape.kind),
                                    area_of(shape), std::numbers::pi * mean(total)));
}

} // namespace lightcuts
