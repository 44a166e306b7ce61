// SPDX-License-Identifier: MIT
#include <oracle/subjects/c_records.h>

#include <variant>

#include <lightcuts/core/input_error.h>

namespace lightcuts::oracle {
namespace {

void copy(const glm::vec3& from, float (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

void set_lobe(lightcuts_material& c, std::uint32_t kind, const glm::vec3& reflectance,
              float width) {
  c.lobe = kind;
  copy(reflectance, c.reflectance);
  c.width = width;
}
void set_lobe(lightcuts_material& /*c*/, const NoLobe& /*none*/) {}
void set_lobe(lightcuts_material& c, const Phong& lobe) {
  set_lobe(c, LIGHTCUTS_LOBE_PHONG, lobe.reflectance, lobe.exponent);
}
void set_lobe(lightcuts_material& c, const Ward& lobe) {
  set_lobe(c, LIGHTCUTS_LOBE_WARD, lobe.reflectance, lobe.alpha);
}
void set_lobe(lightcuts_material& c, const CookTorrance& lobe) {
  set_lobe(c, LIGHTCUTS_LOBE_COOK_TORRANCE, lobe.f0, lobe.alpha);
}

} // namespace

// The C interface does not have LightKind::profile: plug-ins lack Part::profiles. Any other new
// kind would be wanted here.
static_assert(light_kind_count == 5 && int(LightKind::profile) == 4 &&
              int(LightKind::omni) == LIGHTCUTS_LIGHT_OMNI &&
              int(LightKind::oriented) == LIGHTCUTS_LIGHT_ORIENTED &&
              int(LightKind::spot) == LIGHTCUTS_LIGHT_SPOT &&
              int(LightKind::directional) == LIGHTCUTS_LIGHT_DIRECTIONAL);

lightcuts_light as_c(const Light& light) {
  if (light.kind == LightKind::profile)
    throw InputError(InputFault::unsupported,
                     "lights with profiles cannot be given to a plug-in: its interface has none");
  lightcuts_light c{};
  c.kind = std::uint32_t(light.kind);
  copy(light.position, c.position);
  copy(light.intensity, c.intensity);
  copy(light.axis, c.axis);
  c.cos_inner = light.cos_inner;
  c.cos_outer = light.cos_outer;
  return c;
}

lightcuts_point as_c(const ShadingPoint& point) {
  lightcuts_point c{};
  copy(point.position(), c.position);
  copy(point.normal(), c.normal);
  copy(point.to_viewer(), c.to_viewer);
  copy(point.mirror(), c.mirror);
  copy(point.material().diffuse, c.material.diffuse);
  std::visit([&](const auto& lobe) { set_lobe(c.material, lobe); }, point.material().lobe);
  return c;
}

lightcuts_cut_config as_c(const CutConfig& config) {
  return {config.threshold, config.max_size, config.black_level, config.unoccluded ? 1U : 0U};
}

} // namespace lightcuts::oracle
