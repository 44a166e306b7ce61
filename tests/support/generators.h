// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include <rapidcheck.h>

#include <lightcuts/core/geometry/box.h>
#include <oracle/cases/stress_scene.h>

/// Scenes of stress_scene.h for rapidcheck, which shrinks them by simpler.h.
namespace lightcuts::gen {

/// A box, a shading point's position and a direction that need not be unit.
struct BoxView {
  Box box;
  glm::vec3 x, n;
};

std::ostream& operator<<(std::ostream& out, const BoxView& view);

/// Any finite float; often 0, a small integer, subnormal or at an end of the range.
rc::Gen<float> finite_float();
/// Length within 1e-6 of 1; often along an axis, or all but.
rc::Gen<glm::vec3> unit_vector();
/// 1 to max_lights lights of all kinds, growing with rapidcheck's size; all materials; clamped or
/// not.
rc::Gen<Scene> scene(int max_lights = 24);
/// Scenes of omni lights only, diffuse and Phong surfaces, not clamped.
rc::Gen<Scene> plain_scene(int max_lights = 24);
/// Scenes of one kind of light and one kind of lobe (its index in Lobe).
rc::Gen<Scene> scene_of(LightKind kind, std::size_t lobe, bool clamped, int max_lights = 24);
/// 1 to max_lights lights of all kinds, mirrored at a surface that is seen along itself; see
/// make_grazing_scene().
rc::Gen<Scene> grazing_scene(const Choice& choice = {}, int max_lights = 8);
rc::Gen<BoxView> box_view();

/// What `make` makes of dice, not shrunk: for operands of a few numbers.
template <class T>
rc::Gen<T> from_dice(T (*make)(Dice&)) {
  return rc::Gen<T>([make](const rc::Random& random, int) {
    Dice dice(rc::Random(random).next());
    return rc::shrinkable::just(make(dice));
  });
}

/// The value that a generator makes of a seed: for loops outside rapidcheck.
template <class T>
T from_seed(const rc::Gen<T>& generator, std::uint64_t seed, int size = 100) {
  return generator(rc::Random(seed), size).value();
}

} // namespace lightcuts::gen
