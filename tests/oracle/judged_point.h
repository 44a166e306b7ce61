// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <lightcuts/oracle/mutants.h>
#include <lightcuts/oracle/point_properties.h>
#include <lightcuts/tree_builder.h>

namespace lightcuts::oracle {

/// A tree and a shading point with the truth there: what the properties are checked on.
struct JudgedPoint {
  LightTree tree;
  ShadingPoint point;
  std::vector<char> visible;
  Truth truth;

  JudgedPoint(LightTree of, const ShadingPoint& from, std::vector<char> seen)
      : tree(std::move(of)), point(from), visible(std::move(seen)) {
    truth.evaluate(tree, point, visible);
  }
  JudgedPoint(const JudgedPoint&) = delete;
  JudgedPoint& operator=(const JudgedPoint&) = delete;

  [[nodiscard]] PointCase at() const { return {7, point, visible, truth}; }
};

/// Lights of intensity 1, 2, 4 and 8 (green twice, blue thrice that) over the corners of a square.
inline LightTree four_lights() {
  LightSet lights;
  for (int i = 0; i < 4; ++i)
    lights.add_omni({i % 2, i / 2, 1 + i / 2}, float(1 << i) * glm::vec3(1, 2, 3));
  return build(lights);
}

inline ShadingPoint diffuse_point(const glm::vec3& position = glm::vec3(0)) {
  return {position, {0, 0, 1}, {0, 0, 1}, {glm::vec3(0.5F)}};
}

/// The library but for a bound that a test has bent.
class BentSubject : public RulesSubject<LightcutsRules> {
public:
  using Bend = std::function<glm::vec3(std::uint32_t node, glm::vec3 bound)>;

  BentSubject(const LightTree& of, Bend bend)
      : RulesSubject<LightcutsRules>("bent", of), bend_(std::move(bend)) {}
  [[nodiscard]] glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) const override {
    return bend_(node, RulesSubject<LightcutsRules>::bound(node, point));
  }

private:
  Bend bend_;
};

/// The properties that were violated.
inline std::vector<Property> violated(const Tally& tally) {
  std::vector<Property> list;
  for (std::size_t i = 0; i < property_count; ++i)
    if (tally[Property(i)].violations > 0) list.push_back(Property(i));
  return list;
}

} // namespace lightcuts::oracle
