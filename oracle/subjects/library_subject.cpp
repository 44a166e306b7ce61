// SPDX-License-Identifier: MIT
#include <oracle/subjects/library_subject.h>

#include <lightcuts/core/methods/paper_rules.h>
#include <oracle/subjects/rules_subject.h>

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

namespace {

template <class Importance>
class LibrarySubject : public RulesSubject<LightcutsRules, Importance> {
public:
  explicit LibrarySubject(std::string name, Builder builder = Builder::greedy)
      : RulesSubject<LightcutsRules, Importance>(std::move(name)), builder_(builder) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<BatchedTree<Importance>>(lightcuts::build(lights, {seed, builder_}));
  }

private:
  Builder builder_;
};

} // namespace

std::unique_ptr<Subject> library_subject() {
  return std::make_unique<LibrarySubject<HierarchicalImportance<AnyFeatures>>>("lightcuts");
}

std::unique_ptr<Subject> locally_ordered_subject() {
  return std::make_unique<LibrarySubject<HierarchicalImportance<AnyFeatures>>>(
      name_of(Builder::locally_ordered), Builder::locally_ordered);
}

std::unique_ptr<Subject> stochastic_intensity_subject() {
  return std::make_unique<LibrarySubject<IntensityImportance>>("stochastic-intensity");
}

std::unique_ptr<Subject> paper_subject() {
  return std::make_unique<RulesSubject<PaperRules>>("paper");
}

} // namespace lightcuts::oracle
