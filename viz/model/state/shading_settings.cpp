// SPDX-License-Identifier: MIT
#include <viz/model/state/shading_settings.h>

#include <utility>

#include <oracle/subjects/library_subject.h>

namespace lightcuts::viz {
namespace {

/// Draws what the renderer does by that seed.
template <class Importance>
class DrawingTree : public oracle::RulesTree<LightcutsRules, Importance> {
public:
  DrawingTree(std::shared_ptr<const LightTree> tree, std::uint64_t seed)
      : oracle::RulesTree<LightcutsRules, Importance>(std::move(tree)), seed_(seed) {}
  [[nodiscard]] std::unique_ptr<oracle::SubjectTree> for_another_thread() const override {
    return std::make_unique<DrawingTree>(this->shared_tree(), seed_);
  }
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    select_.emplace(this->tree(), config, seed_);
    return (*select_)(point, query, visible);
  }

private:
  std::uint64_t seed_;
  /// Has what was drawn last.
  std::optional<BasicStochasticCutSelector<LightcutsRules, Importance>> select_;
};

} // namespace

CutConfig cut_config(const ShadingSettings& settings, const OpenedScene& scene,
                     const SceneView& view) {
  const auto& c = scene.counterexample();
  const bool may_be_open = !c || c->saved.counterexample.on.cut.unoccluded;
  return {settings.threshold.value_or(scene.default_threshold()), settings.max_cut,
          scene.black_level(), may_be_open && !view.may_occlude()};
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
  if (method == Method::stochastic)
    return std::make_unique<DrawingTree<HierarchicalImportance<AnyFeatures>>>(scene.tree(),
                                                                              settings.seed);
  if (method == Method::stochastic_intensity)
    return std::make_unique<DrawingTree<IntensityImportance>>(scene.tree(), settings.seed);
  return std::make_unique<oracle::RulesTree<ChosenRules>>(scene.tree(), rules_of(method, settings));
}

} // namespace lightcuts::viz
