// SPDX-License-Identifier: MIT
#include <lightcuts/core/methods/chosen_rules.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/cut_promises.h>

namespace lightcuts {
namespace {

/// Of each node bound and estimate by the rules, one after the other.
template <class Rules>
std::vector<glm::dvec3> answers(const Rules& rules, const LightTree& tree,
                                const ShadingPoint& point) {
  std::vector<glm::dvec3> all;
  std::visit(
      [&](const auto& lobe) {
        for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
          const glm::vec3 bound = rules.bound(tree, i, point, lobe);
          all.emplace_back(bound);
          all.push_back(rules.estimate(tree, i, point, lobe, bound));
        }
      },
      point.material().lobe);
  return all;
}

ChosenRules chosen(BoundRule bound, EstimateRule estimate) {
  ChosenRules rules;
  rules.bound_rule = bound;
  rules.estimate_rule = estimate;
  return rules;
}

RC_GTEST_PROP(ChosenRules, AreThoseOfTheMethodsThatHaveNames, ()) {
  const CutCase given = *cut_case();
  const ShadingPoint point = given.scene.view.point();
  const LightTree tree = build(given.scene.light_set());
  const auto by = [&](BoundRule bound, EstimateRule estimate) {
    return answers(chosen(bound, estimate), tree, point);
  };
  RC_ASSERT(by(BoundRule::joint, EstimateRule::centroid) == answers(LightcutsRules(), tree, point));
  RC_ASSERT(by(BoundRule::no_specular, EstimateRule::centroid) ==
            answers(NoSpecularBoundRules(), tree, point));
  RC_ASSERT(by(BoundRule::product, EstimateRule::representative) ==
            answers(PaperRules(), tree, point));
  RC_ASSERT(by(BoundRule::product, EstimateRule::unscaled) ==
            answers(UnscaledRules(), tree, point));
}

} // namespace
} // namespace lightcuts
