// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include <lightcuts/core/kernels/cluster_bound.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/kernels/over_kinds.h>
#include <lightcuts/core/numerics/rounding.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {

// The catalogue, by what is broken.
[[nodiscard]] std::span<const Mutant> bound_mutants();
[[nodiscard]] std::span<const Mutant> tree_mutants();
[[nodiscard]] std::span<const Mutant> cut_mutants();
[[nodiscard]] std::span<const Mutant> sampling_mutants();
[[nodiscard]] std::span<const Mutant> shading_mutants();
[[nodiscard]] std::span<const Mutant> subtle_mutants();
[[nodiscard]] std::span<const Mutant> size_mutants();
[[nodiscard]] std::span<const Mutant> age_mutants();
[[nodiscard]] std::span<const Mutant> block_mutants();
[[nodiscard]] std::span<const Mutant> profile_mutants();
[[nodiscard]] std::span<const Mutant> shaft_mutants();

/// The library's kernel for any tree, of which a mutant puts one thing of its own in place.
struct LibraryKernel : ClusterKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return contribution_bound(tree, node, point);
  }
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, node, point, bound);
  }
};

/// The library with this kernel, for Mutant::make.
template <class Kernel>
std::unique_ptr<Subject> with_kernel(const char* name) {
  return std::make_unique<KernelSubject>(name, std::make_shared<Kernel>());
}

/// The library's suprema, whatever the kind of light; see JointSuprema.
struct AnySuprema {
  virtual ~AnySuprema() = default;
  [[nodiscard]] LightKind kind_of(const TreeNode& cluster) const { return cluster.kind(); }
  [[nodiscard]] virtual double max_cosine_falloff(LightKind kind, const glm::vec3& n,
                                                  const glm::vec3& from, const Box& box,
                                                  double d2) const;
  [[nodiscard]] virtual double max_falloff(LightKind kind, const glm::vec3& from, const Box& box,
                                           double d2) const;
  [[nodiscard]] virtual double max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                                            const glm::vec3& from) const;
};

/// The library's bound by other suprema.
[[nodiscard]] glm::vec3 bound_by(const AnySuprema& suprema, const LightTree& tree,
                                 std::uint32_t node, const ShadingPoint& point);

template <class Suprema>
struct SupremaKernel : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return bound_by(Suprema(), tree, node, point);
  }
};

template <class Suprema>
std::unique_ptr<Subject> with_suprema(const char* name) {
  return with_kernel<SupremaKernel<Suprema>>(name);
}

/// A tree of the library that selects by another rule.
template <class Rule>
class RuleTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<RuleTree>(shared_tree());
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    return loops_.with(config, tree(), *kernel())(point, visible);
  }

private:
  CutLoops<Rule> loops_;
};

/// The library, refining and stopping by another rule.
template <class Rule>
class RuleSubject : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<RuleTree<Rule>>(lightcuts::build(lights, {seed}));
  }
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    return Rule::refined_before(bound, other);
  }
};

template <class Rule>
std::unique_ptr<Subject> with_rule(const char* name) {
  return std::make_unique<RuleSubject<Rule>>(name);
}

/// A tree that is copied for another thread as what it is: Self, made of the library's tree.
template <class Self, class Base = LibraryTree>
class CopiedPerThread : public Base {
public:
  using Base::Base;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<Self>(this->shared_tree());
  }
};

/// The library, its tree answering through `Tree`, made of the library's own.
template <class Tree>
class WithTree : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
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

/// The library with a tree that something has been done to.
template <LightTree build_altered(const LightSet& lights, std::uint64_t seed)>
class OtherTree : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<BatchedTree<>>(build_altered(lights, seed));
  }
};

template <LightTree build_altered(const LightSet& lights, std::uint64_t seed)>
std::unique_ptr<Subject> with_altered(const char* name) {
  return std::make_unique<OtherTree<build_altered>>(name);
}

} // namespace lightcuts::oracle
