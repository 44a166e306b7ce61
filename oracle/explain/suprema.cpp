// SPDX-License-Identifier: MIT
#include <oracle/explain/suprema.h>

#include <cmath>
#include <variant>

#include <lightcuts/core/kernels/block_bound.h>

namespace lightcuts::oracle {

Suprema suprema_at(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  const TreeNode& n = tree.node(node);
  const glm::vec3 from = viewed_from(n.kind(), point.position());
  return visit_kind(n.kind(), [&]<class Kind>(Kind) {
    const JointSuprema<Kind> sup;
    const double clamp2 = tree.min_distance2();
    Suprema s{std::sqrt(min_distance2(from, n.box)),
              sup.max_cosine_falloff(n.kind(), point.normal(), from, n.box, clamp2) *
                  point.inverse_normal_length(),
              sup.max_falloff(n.kind(), from, n.box, clamp2), 1, glm::dvec3(0)};
    if (is_at_infinity(Kind::kind)) s.min_distance = 1;
    if (has_axis(Kind::kind)) s.max_emission = sup.max_emission(tree, node, n.kind(), from);
    const auto bound_of = [&](const auto& lobe) {
      return lobe.bound(BoxSight{point, from, n.box, s.max_cosine_falloff, s.max_falloff});
    };
    if (s.max_cosine_falloff > 0) s.shine = std::visit(bound_of, point.material().lobe);
    return s;
  });
}

Suprema suprema_over(const LightTree& tree, std::uint32_t node, const ShadingBlock& block) {
  const TreeNode& n = tree.node(node);
  return visit_kind(n.kind(), [&]<class Kind>(Kind) {
    const bool far = is_at_infinity(Kind::kind);
    const Box origin{glm::vec3(0), glm::vec3(0)};
    const auto q = DifferenceBox::between(far ? origin : block.positions(), n.box);
    const double clamp2 = tree.min_distance2();
    const double falloff = JointSuprema<Kind>::max_falloff(q, clamp2);
    Suprema s{far ? 1 : std::sqrt(min_length2(q)),
              detail::max_cosine_falloff<Kind>(block.directions().normals, q, clamp2, falloff),
              falloff, 1, glm::dvec3(0)};
    if constexpr (has_axis(Kind::kind)) s.max_emission = Kind::max_emission(tree.emission(node), q);
    const auto bound_of = [&](const auto& lobe) {
      return lobe.bound(BlockSight{block.directions(), q, s.max_cosine_falloff, s.max_falloff});
    };
    if (s.max_cosine_falloff > 0) s.shine = std::visit(bound_of, block.material().lobe);
    return s;
  });
}

} // namespace lightcuts::oracle
