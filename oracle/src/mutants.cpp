// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/mutants.h>

#include <lightcuts/oracle/rules_subject.h>

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
std::unique_ptr<Subject> with_rules(const char* name) {
  return std::make_unique<RulesSubject<Rules>>(name);
}

constexpr Mutant catalogue[] = {
    {"heap-inverted", "refines the smallest bound first, and stops on it",
     with_rules<HeapInverted>},
    {"intensity-of-representative",
     "the bound uses the representative's intensity, not the cluster's",
     with_rules<IntensityOfRepresentative>},
};

} // namespace

std::span<const Mutant> mutants() { return catalogue; }

const Mutant* mutant_named(std::string_view name) {
  for (const Mutant& mutant : catalogue)
    if (name == mutant.name) return &mutant;
  return nullptr;
}

} // namespace lightcuts::oracle
