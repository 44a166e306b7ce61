// SPDX-License-Identifier: MIT
#include <viz/model/picture/shading_settings.h>

#include <utility>

#include <oracle/subjects/library_subject.h>

namespace lightcuts::viz {
namespace {

/// Draws what the renderer does by that seed.
template <class Importance>
class DrawingTree : public oracle::BasicLibraryTree<Importance> {
public:
  DrawingTree(std::shared_ptr<const LightTree> tree, std::uint64_t seed)
      : oracle::BasicLibraryTree<Importance>(std::move(tree)), seed_(seed) {}
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
  std::optional<BasicStochasticCutSelector<Importance>> select_;
};

} // namespace

CutConfig cut_config(const ShadingSettings& settings, const OpenedScene& scene,
                     const SceneView& view) {
  const auto& c = scene.counterexample();
  const bool may_be_open = !c || c->saved.counterexample.on.cut.unoccluded;
  return {settings.threshold.value_or(scene.default_threshold()), settings.max_cut,
          scene.black_level(), may_be_open && !view.may_occlude()};
}

ClusterRules rules_of(Method method, const ShadingSettings& settings) {
  const bool has_its_own = method != methods::lightcuts && method->cuts;
  return has_its_own ? method->rules : settings.rules;
}

std::unique_ptr<oracle::SubjectTree> tree_for(Method method, const ShadingSettings& settings,
                                              const OpenedScene& scene) {
  if (scene.counterexample()) return scene.subject_tree();
  if (method == methods::stochastic)
    return std::make_unique<DrawingTree<HierarchicalImportance>>(scene.tree(), settings.seed);
  if (method == methods::stochastic_intensity)
    return std::make_unique<DrawingTree<IntensityImportance>>(scene.tree(), settings.seed);
  return std::make_unique<oracle::LibraryTree>(
      scene.tree(), oracle::library_kernel(all_light_kinds, rules_of(method, settings)));
}

} // namespace lightcuts::viz
