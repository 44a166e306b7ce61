// SPDX-License-Identifier: MIT
#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

template <class F>
double by_kind(LightKind kind, F&& f) {
  return visit_kind(kind, [&]<class Kind>(Kind) -> double { return f(JointSuprema<Kind>()); });
}

} // namespace

double AnySuprema::max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                                      const Box& box, double d2) const {
  return by_kind(kind, [&](auto s) { return s.max_cosine_falloff(kind, n, from, box, d2); });
}

double AnySuprema::max_falloff(LightKind kind, const glm::vec3& from, const Box& box,
                               double d2) const {
  return by_kind(kind, [&](auto s) { return s.max_falloff(kind, from, box, d2); });
}

double AnySuprema::max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                                const glm::vec3& from) const {
  return by_kind(kind, [&](auto s) { return s.max_emission(tree, i, kind, from); });
}

glm::vec3 bound_by(const AnySuprema& suprema, const LightTree& tree, std::uint32_t node,
                   const ShadingPoint& point) {
  return std::visit(
      [&](const auto& lobe) {
        return bound_over_kinds(tree, node, [&](std::uint32_t i) {
          return cluster_bound(suprema, tree, i, point, lobe);
        });
      },
      point.material().lobe);
}

} // namespace lightcuts::oracle
