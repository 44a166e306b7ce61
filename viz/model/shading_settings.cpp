// SPDX-License-Identifier: MIT
#include "shading_settings.h"

#include <lightcuts/oracle/library_subject.h>

namespace lightcuts::viz {

CutConfig cut_config(const ShadingSettings& settings, const OpenedScene& scene,
                     const SceneView& view) {
  return {settings.threshold.value_or(scene.default_threshold()), settings.max_cut,
          scene.black_level(), !scene.counterexample() && !view.may_occlude()};
}

ChosenRules rules_of(Method method, const ShadingSettings& settings) {
  ChosenRules rules;
  switch (method) {
  case Method::paper:
    rules.bound_rule = BoundRule::product;
    rules.estimate_rule = EstimateRule::representative;
    return rules;
  case Method::unscaled:
    rules.bound_rule = BoundRule::product;
    rules.estimate_rule = EstimateRule::unscaled;
    return rules;
  case Method::no_specular_bound:
    rules.bound_rule = BoundRule::no_specular;
    return rules;
  case Method::stochastic:
  case Method::stochastic_intensity:
    return rules;
  case Method::reference:
  case Method::lightcuts:
    break;
  }
  return settings.rules;
}

std::unique_ptr<oracle::SubjectTree> tree_for(Method method, const ShadingSettings& settings,
                                              const OpenedScene& scene) {
  if (scene.counterexample()) return scene.subject_tree();
  const ChosenRules rules = rules_of(method, settings);
  if (method == Method::stochastic_intensity)
    return std::make_unique<oracle::RulesTree<ChosenRules, IntensityImportance>>(scene.tree(),
                                                                                 rules);
  return std::make_unique<oracle::RulesTree<ChosenRules>>(scene.tree(), rules);
}

} // namespace lightcuts::viz
