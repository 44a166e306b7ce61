// SPDX-License-Identifier: MIT
#include <oracle/cases/blocks.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightcuts::oracle {
namespace {

using gen::Dice;

/// Whether lobes differ in colours at most: what is one number is a matter of shape.
bool of_one_shape(const Lobe& a, const Lobe& b) {
  return std::visit(
      [&b]<class OneLobe>(const OneLobe& own) {
        const auto* other = std::get_if<OneLobe>(&b);
        if (other == nullptr) return false;
        bool same = true;
        for_each_field(
            own, *other,
            [&same]<class Value>(const char*, const Value& mine, const Value& theirs, Domain) {
              if constexpr (std::is_same_v<Value, float>) same = same && mine == theirs;
            });
        return same;
      },
      a);
}

glm::vec3 turned(Dice& dice, const glm::vec3& direction, double by) {
  if (by == 0) return direction;
  const glm::dvec3 offset(dice.uniform(-by, by), dice.uniform(-by, by), dice.uniform(-by, by));
  return glm::vec3(glm::normalize(glm::dvec3(direction) + offset));
}

void recolour(Dice& dice, Material& material) {
  material.diffuse = dice.reflectance();
  std::visit(
      [&dice]<class OneLobe>(OneLobe& lobe) {
        for_each_field(lobe, [&dice]<class Value>(const char*, Value& value, const Domain& domain) {
          if constexpr (std::is_same_v<Value, glm::vec3>)
            value = glm::min(dice.reflectance(), glm::vec3(std::min(domain.most, 1e30)));
        });
      },
      material.lobe);
}

/// How far apart the points are, along one axis or all; from next to each other to the distance of
/// a light.
glm::vec3 extent(Dice& dice, const Case& of, const glm::vec3& from) {
  const Light& light = of.lights[std::size_t(dice.below(int(of.lights.size())))];
  const bool far = light.kind == LightKind::directional;
  const double distance = far ? 1 : glm::distance(glm::dvec3(light.position), glm::dvec3(from));
  const double size = distance * dice.pick({0.0, 1e-6, 0.01, 0.3, 1.0});
  return Dice::finite(size) * (dice.one_in(2) ? glm::abs(dice.axis()) : glm::vec3(1));
}

} // namespace

bool is_block(const Case& of) {
  return !of.views.empty() &&
         std::all_of(of.views.begin(), of.views.end(), [&](const CaseView& view) {
           return of_one_shape(of.views.front().view.material.lobe, view.view.material.lobe);
         });
}

void make_block(Dice& dice, Case& of) {
  const CaseView first = of.views.front();
  const glm::vec3 apart = extent(dice, of, first.view.position);
  const double bent = dice.pick({0.0, 0.0, 1e-6, 0.05, 0.7});
  of.views.resize(1);
  const int others = dice.between(1, 4);
  for (int i = 0; i < others; ++i) {
    CaseView near = first;
    for (int k = 0; k < 3; ++k)
      near.view.position[k] = Dice::finite(near.view.position[k] + apart[k] * dice.uniform(-1, 1));
    near.view.normal = turned(dice, near.view.normal, bent);
    near.view.to_viewer = turned(dice, near.view.to_viewer, bent);
    if (dice.one_in(2)) recolour(dice, near.view.material);
    of.views.push_back(near);
  }
}

} // namespace lightcuts::oracle
