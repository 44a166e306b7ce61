// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/catalogue.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle {
namespace {

/// One float's step aside, and a little apart and turned.
void add_neighbours(Case& c) {
  const CaseView first = c.views.front();
  CaseView step = first, apart = first;
  for (int i = 0; i < 3; ++i) {
    step.view.position[i] = std::nextafter(step.view.position[i], 0.5F);
    const double size = std::max(std::abs(double(apart.view.position[i])), 1.0);
    apart.view.position[i] = gen::Dice::finite(double(apart.view.position[i]) + 0x1p-7 * size);
  }
  const glm::dvec3 turned = glm::dvec3(apart.view.normal) + glm::dvec3(0x1p-9, -0x1p-8, 0);
  apart.view.normal = making::unit(turned);
  apart.view.material.diffuse *= 0.5F;
  c.views.push_back(step);
  c.views.push_back(apart);
}

/// A square at the first view's point, seen along its normal.
void add_picture(Case& c) {
  const gen::View& view = c.views.front().view;
  const glm::dvec3 n = glm::normalize(glm::dvec3(view.normal)), x(view.position);
  const glm::dvec3 side = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const double largest = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  const double size = std::max(1.0, 0x1p-6 * largest);
  const glm::dvec3 u = size * glm::normalize(glm::cross(n, side)), v = glm::cross(n, u);
  const glm::vec3 a(x - u - v), b(x + u - v), d(x + u + v), e(x - u + v);
  c.triangles = {{a, b, d, 0}, {a, d, e, 0}};
  c.camera = {glm::vec3(x + 2 * size * n), view.position, making::unit(u), 40};
  c.image_size = {3, 3};
}

const std::vector<NamedCase>& all_cases() {
  static const std::vector<NamedCase> list = [] {
    std::vector<NamedCase> cases;
    for (const auto& part : {making::counts(), making::scales(), making::places(),
                             making::directions(), making::lobes(), making::triangles()})
      cases.insert(cases.end(), part.begin(), part.end());
    return cases;
  }();
  return list;
}

} // namespace

std::span<const NamedCase> catalogue() { return all_cases(); }

const NamedCase* named_case(std::string_view name) {
  const auto& all = all_cases();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedCase& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Case complete(const NamedCase& of) {
  Case c = of.make();
  if (c.views.size() == 1) add_neighbours(c);
  if (of.is_large) c.views.erase(c.views.begin() + 1); // two are a block
  constexpr std::size_t few = 100; // a picture's shadows are judged by brute force
  constexpr float reach = 1e12F;
  const glm::vec3& x = c.views.front().view.position;
  const bool in_reach = std::abs(x.x) < reach && std::abs(x.y) < reach && std::abs(x.z) < reach;
  if (c.triangles.empty() && c.lights.size() <= few && in_reach) add_picture(c);
  return c;
}

} // namespace lightcuts::oracle
