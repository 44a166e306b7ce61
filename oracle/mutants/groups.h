// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include <oracle/mutants/mutants.h>
#include <oracle/subjects/rules_subject.h>

namespace lightcuts::oracle {

// The catalogue, by what is broken.
[[nodiscard]] std::span<const Mutant> bound_mutants();
[[nodiscard]] std::span<const Mutant> tree_mutants();
[[nodiscard]] std::span<const Mutant> cut_mutants();
[[nodiscard]] std::span<const Mutant> sampling_mutants();
[[nodiscard]] std::span<const Mutant> shading_mutants();
[[nodiscard]] std::span<const Mutant> subtle_mutants();

/// The library's rules, of which some are others: decided at run time, so that a mutant costs no
/// selector of its own.
struct MutantRules : LightcutsRules {
  glm::vec3 (*other_bound)(const LightTree&, std::uint32_t, const ShadingPoint&) = nullptr;
  glm::dvec3 (*other_estimate)(const LightTree&, std::uint32_t, const ShadingPoint&,
                               const glm::vec3& bound) = nullptr;
  bool (*other_obeys)(const glm::vec3& bound, const glm::dvec3& total, const CutConfig&) = nullptr;

  template <class OneLobe>
  glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                  const OneLobe& lobe) const {
    return other_bound != nullptr ? other_bound(tree, node, point)
                                  : LightcutsRules::bound(tree, node, point, lobe);
  }
  template <class OneLobe>
  glm::dvec3 estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                      const OneLobe& lobe, const glm::vec3& bound) const {
    return other_estimate != nullptr ? other_estimate(tree, node, point, bound)
                                     : LightcutsRules::estimate(tree, node, point, lobe, bound);
  }
  [[nodiscard]] bool obeys(const glm::vec3& bound, const glm::dvec3& total,
                           const CutConfig& config) const {
    return other_obeys != nullptr ? other_obeys(bound, total, config)
                                  : LightcutsRules::obeys(bound, total, config);
  }
};

/// The library with these rules, for Mutant::make.
template <class Rules>
std::unique_ptr<Subject> with_rules(const char* name) {
  return std::make_unique<RulesSubject<Rules>>(name);
}

/// bound(tree, node, point, lobe) of a set of rules, for any lobe.
template <class Rules>
glm::vec3 bound_by_rules(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  return std::visit([&](const auto& lobe) { return Rules::bound(tree, node, point, lobe); },
                    point.material().lobe);
}

template <class Rules>
glm::dvec3 estimate_by_rules(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             const glm::vec3& bound) {
  return std::visit(
      [&](const auto& lobe) { return Rules::estimate(tree, node, point, lobe, bound); },
      point.material().lobe);
}

/// The library with the bounds, or the estimates, of other rules.
template <class Rules>
std::unique_ptr<Subject> with_bounds(const char* name) {
  MutantRules rules;
  rules.other_bound = bound_by_rules<Rules>;
  return std::make_unique<RulesSubject<MutantRules>>(name, rules);
}

template <class Rules>
std::unique_ptr<Subject> with_estimates(const char* name) {
  MutantRules rules;
  rules.other_estimate = estimate_by_rules<Rules>;
  return std::make_unique<RulesSubject<MutantRules>>(name, rules);
}

template <class Rules>
std::unique_ptr<Subject> with_stop_test(const char* name) {
  MutantRules rules;
  rules.other_obeys = Rules::obeys;
  return std::make_unique<RulesSubject<MutantRules>>(name, rules);
}

/// The library's rules with bounds by other suprema.
template <class Suprema>
struct BoundedBy : LightcutsRules {
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    return bound_by(Suprema(), tree, node, point, lobe);
  }
};

template <class Suprema>
std::unique_ptr<Subject> with_suprema(const char* name) {
  return with_bounds<BoundedBy<Suprema>>(name);
}

/// A tree that is copied for another thread as what it is: Self, made of the library's tree.
template <class Self, class Base = RulesTree<LightcutsRules>>
class CopiedPerThread : public Base {
public:
  using Base::Base;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<Self>(this->shared_tree());
  }
};

/// The library, its tree answering through `Tree`, made of the library's own.
template <class Tree>
class WithTree : public RulesSubject<LightcutsRules> {
public:
  using RulesSubject::RulesSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<Tree>(
        std::make_shared<const LightTree>(lightcuts::build(lights, {seed})));
  }
};

template <class Tree>
std::unique_ptr<Subject> with_tree(const char* name) {
  return std::make_unique<WithTree<Tree>>(name);
}

} // namespace lightcuts::oracle
