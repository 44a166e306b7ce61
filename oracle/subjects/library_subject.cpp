// SPDX-License-Identifier: MIT
#include <oracle/subjects/library_subject.h>

#include <lightcuts/core/methods/paper.h>
#include <lightcuts/render/view/renderer.h>
#include <oracle/subjects/proven_sights.h>

namespace lightcuts::oracle {

TreeClaim claim_of(const LightTree& tree) {
  TreeClaim claim;
  claim.nodes.reserve(tree.nodes().size());
  for (const TreeNode& node : tree.nodes()) {
    TreeClaim::Node n{.representative = node.representative, .intensity = node.intensity};
    if (node.is_leaf()) {
      n.first_light = std::uint32_t(claim.lights.size());
      n.light_count = 1;
      claim.lights.push_back(node.representative);
    } else {
      n.first_child = std::uint32_t(claim.children.size());
      n.child_count = 2;
      claim.children.push_back(node.first_child);
      claim.children.push_back(node.first_child + 1);
    }
    claim.nodes.push_back(n);
  }
  return claim;
}

SharedKernel library_kernel(LightKinds kinds, const ClusterRules& rules) {
  return {&kernel_for(kinds, rules), [](const ClusterKernel*) {}}; // the library keeps it
}

std::unique_ptr<SubjectTree> KernelSubject::build(const LightSet& lights,
                                                  std::uint64_t seed) const {
  return std::make_unique<LibraryTree>(lightcuts::build(lights, {seed}), kernel_);
}

bool KernelSubject::refined_before(double bound, double other) const {
  return StoppingRule::refined_before(bound, other);
}

bool KernelSubject::sees(const SceneView& view, const VisiblePoint& from,
                         std::uint32_t light) const {
  return view.sees(from, light);
}

std::vector<ProvenSight> KernelSubject::prove(const SceneView& view, const LightTree& tree,
                                              std::span<const VisiblePoint> points) const {
  return proven_sights<ShaftRules>(view, tree, points);
}

Rendering KernelSubject::render(const SceneView& view, const LightTree& tree,
                                const RenderConfig& config) const {
  return lightcuts::render(view, tree, config);
}

namespace {

template <class Importance>
class LibrarySubject : public KernelSubject {
public:
  explicit LibrarySubject(std::string name, Builder builder = Builder::greedy)
      : KernelSubject(std::move(name)), builder_(builder) {}
  [[nodiscard]] Parts parts() const override {
    const Parts all = KernelSubject::parts();
    return builder_ == Builder::greedy ? all : all & ~only(Part::greedy_tree);
  }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<BatchedTree<Importance>>(lightcuts::build(lights, {seed, builder_}));
  }

private:
  Builder builder_;
};

} // namespace

std::unique_ptr<Subject> library_subject() {
  return std::make_unique<LibrarySubject<HierarchicalImportance>>("lightcuts");
}

std::unique_ptr<Subject> locally_ordered_subject() {
  return std::make_unique<LibrarySubject<HierarchicalImportance>>(name_of(Builder::locally_ordered),
                                                                  Builder::locally_ordered);
}

std::unique_ptr<Subject> stochastic_intensity_subject() {
  return std::make_unique<LibrarySubject<IntensityImportance>>("stochastic-intensity");
}

std::unique_ptr<Subject> paper_subject() {
  return std::make_unique<KernelSubject>(methods::paper.name,
                                         library_kernel(all_light_kinds, methods::paper.rules));
}

} // namespace lightcuts::oracle
