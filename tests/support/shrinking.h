// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "dice.h"
#include "generators.h"

namespace lightcuts::gen {

/// Values that are simpler than the given one, the simplest first; none for the simplest of all.
std::vector<float> simpler(const float& value);
std::vector<glm::vec3> simpler_directions(const glm::vec3& v);
std::vector<Scene> simpler(const Scene& scene);
std::vector<BoxView> simpler(const BoxView& view);

/// A generator from a function of dice and rapidcheck's size, and the rule of what is simpler.
template <class T>
rc::Gen<T> shrinking(
    std::function<T(Dice&, int)> make,
    std::function<std::vector<T>(const T&)> rule = [](const T& v) { return simpler(v); }) {
  return rc::Gen<T>([make = std::move(make), rule](const rc::Random& random, int size) {
    Dice dice(random);
    return rc::shrinkable::shrinkRecur(
        make(dice, size), [rule](const T& v) { return rc::seq::fromContainer(rule(v)); });
  });
}

} // namespace lightcuts::gen
