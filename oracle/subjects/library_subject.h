// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/cut/light_sampling.h>
#include <lightcuts/core/cut/stochastic_cut.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/lobes/shading_block.h>
#include <lightcuts/core/tree/light_tree.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// What a LightTree says of itself.
[[nodiscard]] TreeClaim claim_of(const LightTree& tree);

/// A kernel of a subject, shared by the threads that judge it.
using SharedKernel = std::shared_ptr<const ClusterKernel>;

/// The library's own kernel by these rules.
[[nodiscard]] SharedKernel library_kernel(LightKinds kinds, const ClusterRules& rules = {});

/// A cut loop for each configuration that is asked for: a loop keeps its memory from call to call.
template <class Rule>
class CutLoops {
public:
  CutLoop<Rule>& with(const CutConfig& config, const LightTree& tree, const ClusterKernel& kernel) {
    for (auto& [known, loop] : loops_)
      if (known == config) return loop;
    return loops_.emplace_back(config, CutLoop<Rule>(tree, config, kernel)).second;
  }

private:
  std::vector<std::pair<CutConfig, CutLoop<Rule>>> loops_;
};

/// A tree of the library with its own kernel or another one; lights are drawn by Importance.
template <class Importance>
class BasicLibraryTree : public SubjectTree {
public:
  explicit BasicLibraryTree(LightTree tree, SharedKernel kernel = {})
      : BasicLibraryTree(std::make_shared<const LightTree>(std::move(tree)), std::move(kernel)) {}
  /// Shares the tree, as do all that are made for other threads. No kernel: the library's.
  explicit BasicLibraryTree(std::shared_ptr<const LightTree> tree, SharedKernel kernel = {})
      : tree_(std::move(tree)),
        kernel_(kernel ? std::move(kernel) : library_kernel(tree_->lights().kinds())) {}

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BasicLibraryTree>(tree_, kernel_);
  }
  [[nodiscard]] TreeClaim claim() const override { return claim_of(*tree_); }
  [[nodiscard]] const LightTree* library_tree() const override { return tree_.get(); }

  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return kernel_->bound(*tree_, node, point);
  }
  void block_bounds(std::span<const ShadingPoint> points, std::span<glm::vec3> out) override {
    const ShadingBlock block(points);
    for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = contribution_bound(*tree_, i, block);
  }
  glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point) override {
    return kernel_->lower_bound(*tree_, node, point);
  }
  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    return kernel_->estimate(*tree_, node, point, bound);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    return loops_.with(config, *tree_, *kernel_)(point, visible);
  }

  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const LightSample s = sample_light(Importance(), *tree_, node, point, u);
    return {s.light, s.probability};
  }
  double probability(std::uint32_t node, const ShadingPoint& point, std::uint32_t light) override {
    return light_probability(Importance(), *tree_, node, light, point);
  }
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    return random_selector(config)(point, query, visible);
  }

protected:
  [[nodiscard]] const LightTree& tree() const { return *tree_; }
  [[nodiscard]] const std::shared_ptr<const LightTree>& shared_tree() const { return tree_; }
  [[nodiscard]] const SharedKernel& kernel() const { return kernel_; }

  // The choice of a cut by the library's rules: only what is drawn is random.
  using RandomSelector = BasicStochasticCutSelector<Importance>;
  [[nodiscard]] RandomSelector& random_selector(const CutConfig& config) {
    if (!random_ || !(random_->first == config))
      random_.emplace(config, RandomSelector(*tree_, config));
    return random_->second;
  }

private:
  std::shared_ptr<const LightTree> tree_;
  SharedKernel kernel_;
  CutLoops<StoppingRule> loops_;
  std::optional<std::pair<CutConfig, RandomSelector>> random_;
};

using LibraryTree = BasicLibraryTree<HierarchicalImportance>;

/// A tree of the library that answers like BasicLibraryTree, sooner where there is much to be
/// answered at once. What is derived from it and answers one bound(), probability() or draw()
/// otherwise has to do so at once, too: BatchedTree would go on answering that itself.
template <class Importance = HierarchicalImportance>
class BatchedTree : public BasicLibraryTree<Importance> {
public:
  using BasicLibraryTree<Importance>::BasicLibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BatchedTree>(this->shared_tree());
  }
  void bounds(const ShadingPoint& point, std::span<glm::vec3> out) override {
    contribution_bounds(this->tree(), point, out);
  }
  std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                    std::span<const std::uint32_t> lights) override {
    std::unordered_map<std::uint32_t, double> known;
    visit_probabilities(Importance(), this->tree(), node, point,
                        [&](std::uint32_t light, double p) { known[light] = p; });
    std::vector<double> result;
    for (const std::uint32_t light : lights) result.push_back(known[light]);
    return result;
  }
  void draws(const ShadingPoint& point, const CutConfig& config,
             std::span<const std::uint64_t> queries,
             const std::function<bool(std::uint32_t)>& visible,
             const std::function<void(const Cut&)>& take) override {
    auto& select = this->random_selector(config);
    for (std::size_t i = 0; i < queries.size(); ++i)
      take(i == 0 ? select(point, queries[i], visible) : select.again(point, queries[i], visible));
  }
};

/// The library, or, with another kernel, what a mutant derives from to put one thing of its own in
/// place.
class KernelSubject : public Subject {
public:
  explicit KernelSubject(std::string name, SharedKernel kernel = {})
      : name_(std::move(name)), kernel_(std::move(kernel)) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Parts parts() const override { return all_parts_and_claims; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override;
  [[nodiscard]] bool refined_before(double bound, double other) const override;
  [[nodiscard]] bool sees(const SceneView& view, const VisiblePoint& from,
                          std::uint32_t light) const override;
  [[nodiscard]] std::vector<ProvenSight> prove(const SceneView& view, const LightTree& tree,
                                               std::span<const VisiblePoint> points) const override;
  [[nodiscard]] Rendering render(const SceneView& view, const LightTree& tree,
                                 const RenderConfig& config) const override;

private:
  std::string name_;
  SharedKernel kernel_;
};

/// The library, by name "lightcuts".
[[nodiscard]] std::unique_ptr<Subject> library_subject();

/// The library on trees of Builder::locally_ordered, by name "locally-ordered".
[[nodiscard]] std::unique_ptr<Subject> locally_ordered_subject();

/// The library, drawing lights by intensity alone, by name "stochastic-intensity".
[[nodiscard]] std::unique_ptr<Subject> stochastic_intensity_subject();

/// The library by the rules of the method of that name: "paper".
[[nodiscard]] std::unique_ptr<Subject> paper_subject();

} // namespace lightcuts::oracle
