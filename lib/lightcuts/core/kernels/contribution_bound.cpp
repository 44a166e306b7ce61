// SPDX-License-Identifier: MIT
#include <lightcuts/core/kernels/contribution_bound.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include <lightcuts/core/kernels/kind_kernel.h>
#include <lightcuts/core/kernels/over_kinds.h>

namespace lightcuts {
namespace {

template <class... Kinds>
std::array<const KindKernel*, sizeof...(Kinds)> kernels_of(const std::tuple<Kinds...>* /*list*/) {
  return {&CompiledForKind<Kinds>::kernel()...};
}

const KindKernel& kernel_of(const TreeNode& cluster) { return kernel_of(cluster.kind()); }

glm::dvec3 transfer_of(const LightTree& tree, const Light& light, const ShadingPoint& point) {
  glm::dvec3 result;
  kernel_of(light.kind).transfers(point, {&light, 1}, tree.min_distance2(), &result);
  return result;
}

glm::vec3 rounded_down(const glm::dvec3& v) {
  return {round_down(v.x), round_down(v.y), round_down(v.z)};
}

} // namespace

const KindKernel& kernel_of(LightKind kind) {
  static const auto all = kernels_of(static_cast<const LightKindList*>(nullptr));
  return *all[std::size_t(kind)];
}

glm::dvec3 transfer(const ShadingPoint& point, const Light& light, float min_distance) {
  glm::dvec3 result;
  kernel_of(light.kind).transfers(point, {&light, 1}, double(min_distance) * min_distance, &result);
  return result;
}

glm::vec3 contribution_bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                             BoundRule rule) {
  return bound_over_kinds(tree, node, [&](std::uint32_t i) {
    return kernel_of(tree.node(i)).bound[int(rule)](tree, i, point);
  });
}

glm::vec3 contribution_bound(const LightTree& tree, std::uint32_t node, const ShadingBlock& block) {
  return bound_over_kinds(tree, node, [&](std::uint32_t i) {
    return kernel_of(tree.node(i)).block_bound(tree, i, block);
  });
}

void contribution_bounds(const LightTree& tree, const ShadingPoint& point,
                         std::span<glm::vec3> bounds) {
  assert(bounds.size() == tree.nodes().size());
  const LightKinds kinds = tree.lights().kinds();
  if (std::has_single_bit(kinds)) return kernel_of(tree.node(0)).all_bounds(tree, point, bounds);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) bounds[i] = contribution_bound(tree, i, point);
}

glm::vec3 cosine_bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  return kernel_of(tree.node(node)).cosine_bound(tree, node, point);
}

glm::vec3 contribution_lower_bound(const LightTree& tree, std::uint32_t node,
                                   const ShadingPoint& point) {
  return rounded_down(over_kinds(tree, node, [&](std::uint32_t i) {
    return kernel_of(tree.node(i)).lower_bound(tree, i, point);
  }));
}

glm::vec3 contribution_lower_bound(const LightTree& tree, std::uint32_t node,
                                   const ShadingBlock& block) {
  return rounded_down(over_kinds(tree, node, [&](std::uint32_t i) {
    return kernel_of(tree.node(i)).block_lower_bound(tree, i, block);
  }));
}

glm::dvec3 cluster_estimate(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                            const glm::vec3& bound, EstimateRule rule) {
  const TreeNode& cluster = tree.node(node);
  const Light& representative = tree.lights()[cluster.representative];
  switch (rule) {
  case EstimateRule::representative: {
    const glm::dvec3 e = transfer_of(tree, representative, point) * cluster.intensity;
    // Of a mixed cluster the representative says little; nor is it below the bound.
    return cluster.is_mixed() ? glm::min(e, glm::dvec3(bound)) : e;
  }
  case EstimateRule::unscaled:
    return transfer_of(tree, representative, point) * glm::dvec3(representative.intensity);
  case EstimateRule::centroid:
    break;
  }
  const glm::dvec3 e = over_kinds(tree, node, [&](std::uint32_t i) {
    return kernel_of(tree.node(i)).centroid_estimate(tree, i, point);
  });
  return cluster.is_leaf() ? e : glm::min(e, glm::dvec3(bound));
}

void centroid_estimates(const LightTree& tree, std::uint32_t node,
                        std::span<const ShadingPoint* const> points,
                        std::span<glm::dvec3> results) {
  assert(results.size() == points.size());
  if (points.empty()) return;
  if (!tree.node(node).is_mixed())
    return kernel_of(tree.node(node)).centroid_estimates(tree, node, points, results.data());
  std::transform(points.begin(), points.end(), results.begin(), [&](const ShadingPoint* point) {
    return over_kinds(tree, node, [&](std::uint32_t i) {
      return kernel_of(tree.node(i)).centroid_estimate(tree, i, *point);
    });
  });
}

} // namespace lightcuts
