// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/json_shapes.h>

#include <numbers>
#include <string>
#include <vector>

#include <lightcuts/core/numerics/number_text.h>
#include <lightcuts/core/numerics/rounding.h>

#include <lightcuts/render/lighting/direction_sampling.h>

namespace lightcuts {
namespace {

float size_in(const JsonElement& element, const char* key) {
  const float value = element[key].number();
  if (!(value > 0))
    element[key].refuse(InputFault::out_of_domain,
                        "is " + number_text(value) + ", expected more than 0");
  return value;
}

/// Either the radiance, or the power that it makes.
glm::vec3 radiance_in(const JsonElement& element, double area) {
  if (element.has("radiance") == element.has("power"))
    element.refuse(InputFault::inconsistent, "needs either radiance or power");
  if (element.has("radiance")) return element["radiance"].colour();
  const glm::dvec3 radiance = glm::dvec3(element["power"].colour()) / (std::numbers::pi * area);
  return {to_float(radiance.x), to_float(radiance.y), to_float(radiance.z)};
}

} // namespace

ShapeLights read_shape(const JsonElement& element, ShapeKind kind) {
  std::vector<std::string> keys{"generate", "count", "seed", "position", "radiance", "power"};
  const auto allow = [&keys](std::initializer_list<const char*> more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (kind == ShapeKind::rectangle) allow({"normal", "along", "width", "height"});
  if (kind == ShapeKind::disc) allow({"normal", "radius"});
  if (kind == ShapeKind::sphere) allow({"radius"});
  if (kind == ShapeKind::tube) allow({"axis", "radius", "length"});
  element.expect_keys(keys);
  ShapeLights shape{.kind = kind};
  shape.centre = element["position"].vector();
  if (kind == ShapeKind::tube) shape.axis = element["axis"].direction();
  if (kind == ShapeKind::rectangle || kind == ShapeKind::disc)
    shape.axis = element["normal"].direction();
  if (kind == ShapeKind::rectangle) {
    shape.sides = {size_in(element, "width"), size_in(element, "height")};
    shape.along = element.has("along") ? element["along"].direction()
                                       : glm::vec3(perpendicular(glm::dvec3(shape.axis)));
  } else {
    shape.radius = size_in(element, "radius");
  }
  if (kind == ShapeKind::tube) shape.length = size_in(element, "length");
  shape.radiance = radiance_in(element, area_of(shape));
  if (element.has("count"))
    shape.count =
        static_cast<std::uint32_t>(element["count"].whole_number(1, ShapeLights::max_count));
  if (element.has("seed")) shape.seed = element["seed"].whole_number(0, UINT64_MAX);
  return shape;
}

} // namespace lightcuts
