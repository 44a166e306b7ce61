// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <lightcuts/core/cut/light_sampling.h>
#include <lightcuts/core/cut/stochastic_cut.h>
#include <lightcuts/core/kernels/contribution_bounds.h>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// What a LightTree says of itself.
[[nodiscard]] TreeClaim claim_of(const LightTree& tree);

/// A tree of the library with the given rules: LightcutsRules, PaperRules, or a mutant's; lights
/// are drawn by Importance.
template <class Rules, class Importance = HierarchicalImportance<AnyFeatures>>
class RulesTree : public SubjectTree {
public:
  explicit RulesTree(LightTree tree, Rules rules = {})
      : tree_(std::make_shared<const LightTree>(std::move(tree))), rules_(std::move(rules)) {}

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<RulesTree>(tree_, rules_);
  }
  [[nodiscard]] TreeClaim claim() const override { return claim_of(*tree_); }
  [[nodiscard]] const LightTree* library_tree() const override { return tree_.get(); }

  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return std::visit([&](const auto& lobe) { return rules_.bound(*tree_, node, point, lobe); },
                      point.material().lobe);
  }
  glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point) override {
    return contribution_lower_bound(*tree_, node, point);
  }
  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    return std::visit(
        [&](const auto& lobe) { return rules_.estimate(*tree_, node, point, lobe, bound); },
        point.material().lobe);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    return selector(config)(point, visible);
  }

  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    return std::visit(
        [&](const auto& lobe) -> DrawnLight {
          const LightSample s = sample_light(Importance(), *tree_, node, point, lobe, u);
          return {s.light, s.probability};
        },
        point.material().lobe);
  }
  double probability(std::uint32_t node, const ShadingPoint& point, std::uint32_t light) override {
    return std::visit(
        [&](const auto& lobe) {
          return light_probability(Importance(), *tree_, node, light, point, lobe);
        },
        point.material().lobe);
  }
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    if (!random_ || !(random_->first == config))
      random_.emplace(config, RandomSelector(*tree_, config));
    return random_->second(point, query, visible);
  }

  /// Of trees that share all but what a thread needs for itself.
  explicit RulesTree(std::shared_ptr<const LightTree> tree, Rules rules = {})
      : tree_(std::move(tree)), rules_(std::move(rules)) {}

protected:
  [[nodiscard]] const LightTree& tree() const { return *tree_; }
  [[nodiscard]] const std::shared_ptr<const LightTree>& shared_tree() const { return tree_; }
  [[nodiscard]] Rules& rules() { return rules_; }

private:
  // A selector keeps its memory from call to call.
  BasicCutSelector<Rules>& selector(const CutConfig& config) {
    for (auto& [known, selector] : selectors_)
      if (known == config) return selector;
    return selectors_.emplace_back(config, BasicCutSelector<Rules>(*tree_, config, rules_)).second;
  }

  std::shared_ptr<const LightTree> tree_;
  Rules rules_;
  std::vector<std::pair<CutConfig, BasicCutSelector<Rules>>> selectors_;
  // The choice of a cut by the library's rules: only what is drawn is random.
  using RandomSelector = BasicStochasticCutSelector<LightcutsRules, Importance>;
  std::optional<std::pair<CutConfig, RandomSelector>> random_;
};

/// The library's own: the same answers, sooner where there are many at once. Not to be derived
/// from: it would go on answering these itself.
template <class Importance = HierarchicalImportance<AnyFeatures>>
class BatchedTree final : public RulesTree<LightcutsRules, Importance> {
public:
  using RulesTree<LightcutsRules, Importance>::RulesTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BatchedTree>(this->shared_tree());
  }
  void bounds(const ShadingPoint& point, std::span<glm::vec3> out) override {
    contribution_bounds(this->tree(), point, out);
  }
  std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                    std::span<const std::uint32_t> lights) override {
    std::unordered_map<std::uint32_t, double> known;
    std::visit(
        [&](const auto& lobe) {
          visit_probabilities(Importance(), this->tree(), node, point, lobe,
                              [&](std::uint32_t light, double p) { known[light] = p; });
        },
        point.material().lobe);
    std::vector<double> result;
    for (const std::uint32_t light : lights) result.push_back(known[light]);
    return result;
  }
};

/// The library, by name "lightcuts".
[[nodiscard]] std::unique_ptr<Subject> library_subject();

/// The same on trees of Builder::locally_ordered, by name "locally-ordered".
[[nodiscard]] std::unique_ptr<Subject> locally_ordered_subject();

/// The library, drawing lights by intensity alone, by name "stochastic-intensity".
[[nodiscard]] std::unique_ptr<Subject> stochastic_intensity_subject();

/// Method::paper.
[[nodiscard]] std::unique_ptr<Subject> paper_subject();

} // namespace lightcuts::oracle
