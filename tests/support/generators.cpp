// SPDX-License-Identifier: MIT
#include <tests/support/generators.h>

#include <functional>
#include <ios>
#include <ostream>
#include <utility>

#include <oracle/cases/simpler.h>
#include <oracle/numbers/dice.h>

namespace lightcuts::gen {
namespace {

using gen::simpler; // beside that of BoxView

BoxView make_box_view(Dice& dice) {
  const Scene scene = make_scene(dice, dice.between(1, 4), {LightKind::omni, 0, false});
  BoxView view{Box::empty(), scene.view.position,
               dice.one_in(6) ? dice.finite_vector() : scene.view.normal};
  for (const Light& light : scene.lights) view.box.extend(light.position);
  if (dice.one_in(6))
    for (int i = 0; i < 3; ++i) view.x[i] = dice.one_in(2) ? view.box.lo[i] : view.box.hi[i];
  return view;
}

std::vector<BoxView> simpler(const BoxView& view) {
  std::vector<BoxView> list;
  const auto simplify = [&](glm::vec3 (*get)(const BoxView&), glm::vec3& (*set)(BoxView&)) {
    for (const glm::vec3& value : gen::simpler(get(view))) {
      list.push_back(view);
      set(list.back()) = value;
    }
  };
  simplify([](const BoxView& v) { return v.x; }, [](BoxView& v) -> glm::vec3& { return v.x; });
  simplify([](const BoxView& v) { return v.n; }, [](BoxView& v) -> glm::vec3& { return v.n; });
  simplify([](const BoxView& v) { return v.box.lo; },
           [](BoxView& v) -> glm::vec3& { return v.box.lo; });
  simplify([](const BoxView& v) { return v.box.hi; },
           [](BoxView& v) -> glm::vec3& { return v.box.hi; });
  std::erase_if(list, [](const BoxView& v) {
    return v.box.lo.x > v.box.hi.x || v.box.lo.y > v.box.hi.y || v.box.lo.z > v.box.hi.z;
  });
  return list;
}

/// A generator from a function of dice and rapidcheck's size, and the rule of what is simpler.
template <class T>
rc::Gen<T> shrinking(
    std::function<T(Dice&, int)> make,
    std::function<std::vector<T>(const T&)> rule = [](const T& v) { return simpler(v); }) {
  return rc::Gen<T>([make = std::move(make), rule](const rc::Random& random, int size) {
    Dice dice(rc::Random(random).next());
    return rc::shrinkable::shrinkRecur(
        make(dice, size), [rule](const T& v) { return rc::seq::fromContainer(rule(v)); });
  });
}

} // namespace

std::ostream& operator<<(std::ostream& out, const BoxView& view) {
  const auto show = [&out](const char* name, const glm::vec3& v) {
    out << name << " {" << std::hexfloat << v.x << ", " << v.y << ", " << v.z << std::defaultfloat
        << "} ";
  };
  show("box: lo", view.box.lo);
  show("hi", view.box.hi);
  show("x", view.x);
  show("n", view.n);
  return out;
}

rc::Gen<float> finite_float() {
  return shrinking<float>([](Dice& dice, int) { return dice.finite_float(); });
}

rc::Gen<glm::vec3> unit_vector() {
  return shrinking<glm::vec3>([](Dice& dice, int) { return dice.unit_vector(); },
                              simpler_directions);
}

namespace {

rc::Gen<Scene> scene_from(const Choice& choice, int max_lights,
                          Scene (*make)(Dice&, int, const Choice&) = make_scene) {
  return shrinking<Scene>([choice, max_lights, make](Dice& dice, int size) {
    const int count = dice.between(1, 1 + (max_lights - 1) * std::min(size, 100) / 100);
    return make(dice, count, choice);
  });
}

} // namespace

rc::Gen<Scene> scene(int max_lights) { return scene_from({}, max_lights); }

rc::Gen<Scene> plain_scene(int max_lights) {
  return rc::gen::oneOf(scene_of(LightKind::omni, 0, false, max_lights),
                        scene_of(LightKind::omni, 1, false, max_lights));
}

rc::Gen<Scene> scene_of(LightKind kind, std::size_t lobe, bool clamped, int max_lights) {
  return scene_from({kind, lobe, clamped}, max_lights);
}

rc::Gen<Scene> grazing_scene(const Choice& choice, int max_lights) {
  return scene_from(choice, max_lights, make_grazing_scene);
}

rc::Gen<BoxView> box_view() {
  return shrinking<BoxView>([](Dice& dice, int) { return make_box_view(dice); });
}

} // namespace lightcuts::gen
