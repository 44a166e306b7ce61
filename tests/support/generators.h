// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include <rapidcheck.h>

#include <lightcuts/box.h>
#include <lightcuts/light_set.h>
#include <lightcuts/shading_point.h>

/// What this field finds hard: exact ties, clumps, lights on the surface and at the shading point,
/// scales that differ by 10^30, the ends of the float range. Shrinks towards few lights, round
/// numbers and the origin.
namespace lightcuts::gen {

/// What a ShadingPoint is made of.
struct View {
  glm::vec3 position{0}, normal{0, 0, 1}, to_viewer{0, 0, 1};
  Material material{glm::vec3(1), {}};

  [[nodiscard]] ShadingPoint point() const { return {position, normal, to_viewer, material}; }
};

struct Scene {
  std::vector<Light> lights;
  View view;
  float min_distance = 0; ///< 0: no clamp

  [[nodiscard]] LightSet light_set() const;
};

/// A box, a shading point's position and a direction that need not be unit.
struct BoxView {
  Box box;
  glm::vec3 x, n;
};

std::ostream& operator<<(std::ostream& out, const View& view);
std::ostream& operator<<(std::ostream& out, const Scene& scene);
std::ostream& operator<<(std::ostream& out, const BoxView& view);

/// Any finite float; often 0, a small integer, subnormal or at an end of the range.
rc::Gen<float> finite_float();
/// Length within 1e-6 of 1; often along an axis, or all but.
rc::Gen<glm::vec3> unit_vector();
/// 1 to max_lights lights of all kinds, growing with rapidcheck's size; all materials; clamped or
/// not.
rc::Gen<Scene> scene(int max_lights = 24);
/// The same of omni lights only, diffuse and Phong surfaces, not clamped.
rc::Gen<Scene> plain_scene(int max_lights = 24);
/// The same of one kind of light and one kind of lobe (its index in Lobe).
rc::Gen<Scene> scene_of(LightKind kind, std::size_t lobe, bool clamped, int max_lights = 24);
rc::Gen<BoxView> box_view();

/// The value that a generator makes of a seed: for loops outside rapidcheck.
template <class T>
T from_seed(const rc::Gen<T>& generator, std::uint64_t seed, int size = 100) {
  return generator(rc::Random(seed), size).value();
}

} // namespace lightcuts::gen
