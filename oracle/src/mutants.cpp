// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/mutants.h>

#include <lightcuts/paper_rules.h>

namespace lightcuts::oracle {
namespace {

struct HeapInverted : LightcutsRules {
  static bool refined_before(double key, double other) { return key < other; }
  template <class AllObey>
  static bool stops(AllObey&&) {
    return true;
  }
};

struct IntensityOfRepresentative : LightcutsRules {
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    const TreeNode& cluster = tree.node(node);
    const glm::vec3& intensity = tree.lights()[cluster.representative].intensity;
    const glm::vec3 bound = LightcutsRules::bound(tree, node, point, lobe);
    glm::vec3 result(0);
    for (int c = 0; c < 3; ++c)
      if (cluster.intensity[c] > 0)
        result[c] = to_float(bound[c] * (double(intensity[c]) / cluster.intensity[c]));
    return result;
  }
};

template <class Rules>
std::unique_ptr<Subject> make(const char* name, const LightTree& tree) {
  return std::make_unique<RulesSubject<Rules>>(name, tree);
}

constexpr Mutant catalogue[] = {
    {"heap-inverted", "refines the smallest bound first, and stops on it",
     [](const LightTree& tree) { return make<HeapInverted>("heap-inverted", tree); }},
    {"intensity-of-representative",
     "the bound uses the representative's intensity, not the cluster's",
     [](const LightTree& tree) {
       return make<IntensityOfRepresentative>("intensity-of-representative", tree);
     }},
};

} // namespace

std::span<const Mutant> mutants() { return catalogue; }

std::unique_ptr<Subject> library_subject(const LightTree& tree) {
  return make<LightcutsRules>("lightcuts", tree);
}

std::unique_ptr<Subject> paper_subject(const LightTree& tree) {
  return make<PaperRules>("paper", tree);
}

} // namespace lightcuts::oracle
