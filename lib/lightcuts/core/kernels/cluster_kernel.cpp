// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/cluster_kernel.h>

#include <array>
#include <bit>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/kernels/kind_kernel.h>

namespace lightcuts {
namespace {

/// Trees whose lights are all of one kind, by the default rules.
class UniformKernel final : public ClusterKernel {
public:
  explicit UniformKernel(const KindKernel& kernel) : kernel_(kernel) {}

  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return kernel_.bound[int(BoundRule::joint)](tree, node, point);
  }
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, node, point, bound);
  }
  [[nodiscard]] glm::vec3 lower_bound(const LightTree& tree, std::uint32_t node,
                                      const ShadingPoint& point) const override {
    const glm::dvec3 bound = kernel_.lower_bound(tree, node, point);
    return {round_down(bound.x), round_down(bound.y), round_down(bound.z)};
  }
  void evaluate(const LightTree& tree, const ShadingPoint& point,
                std::span<CutCluster> clusters) const override {
    kernel_.evaluate(tree, point, clusters);
  }

private:
  const KindKernel& kernel_;
};

/// Any tree, by any rules.
class RuledKernel final : public ClusterKernel {
public:
  explicit RuledKernel(const ClusterRules& rules) : rules_(rules) {}

  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return contribution_bound(tree, node, point, rules_.bound);
  }
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, node, point, bound, rules_.estimate);
  }

private:
  ClusterRules rules_;
};

template <std::size_t... I>
std::array<UniformKernel, sizeof...(I)> uniform_kernels(std::index_sequence<I...> /*kinds*/) {
  return {UniformKernel(kernel_of(LightKind(I)))...};
}

template <std::size_t... I>
std::array<RuledKernel, sizeof...(I)> ruled_kernels(std::index_sequence<I...> /*rules*/) {
  return {
      RuledKernel({BoundRule(I / estimate_rule_count), EstimateRule(I % estimate_rule_count)})...};
}

} // namespace

glm::vec3 ClusterKernel::lower_bound(const LightTree& tree, std::uint32_t node,
                                     const ShadingPoint& point) const {
  return contribution_lower_bound(tree, node, point);
}

void ClusterKernel::evaluate(const LightTree& tree, const ShadingPoint& point,
                             std::span<CutCluster> clusters) const {
  for (CutCluster& c : clusters) {
    const bool leaf = tree.node(c.node).is_leaf();
    c.bound = leaf ? glm::vec3(0) : bound(tree, c.node, point);
    c.estimate = glm::dvec3(0);
    if (c.visible && (leaf || c.bound != glm::vec3(0)))
      c.estimate = estimate(tree, c.node, point, c.bound);
  }
}

const ClusterKernel& kernel_for(LightKinds kinds, const ClusterRules& rules) {
  static const auto uniform = uniform_kernels(std::make_index_sequence<light_kind_count>());
  static const auto ruled =
      ruled_kernels(std::make_index_sequence<bound_rule_count * estimate_rule_count>());
  if (std::has_single_bit(kinds) && rules == ClusterRules())
    return uniform[std::size_t(std::countr_zero(kinds))];
  return ruled[std::size_t(int(rules.bound) * estimate_rule_count + int(rules.estimate))];
}

} // namespace lightcuts
