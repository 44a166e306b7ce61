// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/shading_point.h>
#include <oracle/numbers/dice.h>

/// Random scenes of what this field finds hard: exact ties, clumps, lights on the surface and at
/// the shading point, scales that differ by 10^30, the ends of the float range, mirrors seen along
/// their surface.
namespace lightcuts::gen {

/// What a ShadingPoint is made of.
struct View {
  glm::vec3 position{0}, normal{0, 0, 1}, to_viewer{0, 0, 1};
  Material material{glm::vec3(1), {}};

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("position", &View::position);
    field("normal", &View::normal, domain::unit);
    field("to_viewer", &View::to_viewer, domain::unit);
    field("material", &View::material);
  }

  [[nodiscard]] ShadingPoint point() const { return {position, normal, to_viewer, material}; }
  bool operator==(const View&) const = default;
};

struct Scene {
  std::vector<Light> lights;
  View view;
  float min_distance = 0; ///< 0: no clamp

  template <class Visitor>
  static constexpr void fields(Visitor&& field) {
    field("lights", &Scene::lights);
    field("view", &Scene::view);
    field("min_distance", &Scene::min_distance, domain::not_negative);
  }

  [[nodiscard]] LightSet light_set() const;
};

/// What a scene is drawn from.
struct Choice {
  std::optional<LightKind> kind = {};   ///< nothing: any, mostly one
  std::optional<std::size_t> lobe = {}; ///< index into Lobe; nothing: any
  std::optional<bool> clamped = {};
};

/// One in eight, where lobes are drawn, is a make_grazing_scene(), and one in eight of the others a
/// make_peak_scene().
[[nodiscard]] Scene make_scene(Dice& dice, int count, const Choice& choice = {});
/// A surface seen along itself, under an angle of any scale down to the least that floats have, and
/// lights where it mirrors the viewer, to the last bit or nearly: l and v cancel but for their
/// parts along the normal.
[[nodiscard]] Scene make_grazing_scene(Dice& dice, int count, const Choice& choice = {});
/// Lights where something is largest: n.l, a lobe, an axis that points to the viewer, n.l/d^2 on a
/// line. Around them lights that are dark or alike, whose axes differ by 10^-3 to 10^-7; directions
/// as long or as short as they may be.
[[nodiscard]] Scene make_peak_scene(Dice& dice, int count, const Choice& choice = {});
/// Another view of such lights: often at one of them, or on faces of their boxes.
[[nodiscard]] View make_view(Dice& dice, const std::vector<Light>& lights,
                             const Choice& choice = {});

/// What the light has apart from kind, position and intensity, by its kind.
void finish(Dice& dice, Light& light, const glm::vec3& seen_from);

std::ostream& operator<<(std::ostream& out, const View& view);
std::ostream& operator<<(std::ostream& out, const Scene& scene);

} // namespace lightcuts::gen
