// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

using Library = AnySuprema;

/// The library's bound, then something done to it.
template <glm::vec3 alter(const glm::vec3& bound, const LightTree& tree, std::uint32_t node,
                          const ShadingPoint& point)>
struct Altered : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return alter(LibraryKernel::bound(tree, node, point), tree, node, point);
  }
};

glm::vec3 one_ulp_down(const glm::vec3& bound, const LightTree&, std::uint32_t,
                       const ShadingPoint&) {
  return {std::nextafter(bound.x, 0.0F), std::nextafter(bound.y, 0.0F),
          std::nextafter(bound.z, 0.0F)};
}

/// Of the two kinds of a mixed cluster's children, the brighter one.
glm::vec3 larger_of_mixed(const glm::vec3& bound, const LightTree& tree, std::uint32_t node,
                          const ShadingPoint& point) {
  if (!tree.node(node).is_mixed()) return bound;
  const std::uint32_t child = tree.node(node).first_child;
  return glm::max(contribution_bound(tree, child, point),
                  contribution_bound(tree, child + 1, point));
}

struct HalvedOnFaces : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const double max_cosine_falloff = Library::max_cosine_falloff(kind, n, from, box, d2);
    for (int i = 0; i < 3; ++i)
      if (box.lo[i] < box.hi[i] && (from[i] == box.lo[i] || from[i] == box.hi[i]))
        return 0.5 * max_cosine_falloff;
    return max_cosine_falloff;
  }
};

struct NormalTakenForUnit : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    const double length = glm::length(glm::dvec3(n));
    return Library::max_cosine_falloff(kind, n, from, box, d2) *
           length; // divided out later: once too seldom
  }
};

struct ClampOnePerMille : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    return Library::max_cosine_falloff(kind, n, from, box, 1.001 * d2);
  }
};

struct ConeOneInAMillion : Library {
  double max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                      const glm::vec3& from) const override {
    ClusterEmission e = tree.emission(i);
    e.cone.chord2 *= 1 - 2e-6F; // the square
    return visit_kind(kind, [&]<class Kind>(Kind) {
      return Kind::max_emission(e, DifferenceBox(from, tree.node(i).box));
    });
  }
};

/// Axes less than a thousandth apart are one axis.
struct AxesTakenForOne : Library {
  double max_emission(const LightTree& tree, std::uint32_t i, LightKind kind,
                      const glm::vec3& from) const override {
    ClusterEmission e = tree.emission(i);
    if (e.cone.chord2 < 1e-6F) e.cone.chord2 = 0;
    return visit_kind(kind, [&]<class Kind>(Kind) {
      return Kind::max_emission(e, DifferenceBox(from, tree.node(i).box));
    });
  }
};

/// Estimates by the light that stands for another cluster.
struct EstimateOfSibling : LibraryKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    const TreeNode& n = tree.node(node);
    if (n.is_leaf()) return LibraryKernel::estimate(tree, node, point, bound);
    const Light& other = tree.lights()[(n.representative + 1) % tree.lights().size()];
    const glm::dvec3 one = transfer(point, other, tree.lights().min_distance()) * n.intensity;
    return glm::min(one, glm::dvec3(bound));
  }
};

/// Estimates a cluster by its first child alone.
struct EstimateOfHalf : LibraryKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    const TreeNode& n = tree.node(node);
    return LibraryKernel::estimate(tree, n.is_leaf() ? node : n.first_child, point, bound);
  }
};

struct BoxOneUlpShort : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    Box shorter = box;
    if (box.lo.x < box.hi.x) shorter.hi.x = std::nextafter(box.hi.x, box.lo.x);
    return Library::max_cosine_falloff(kind, n, from, shorter, d2);
  }
};

/// Corners and the ray along the normal, but only eleven of the twelve edges.
struct OneEdgeForgotten : Library {
  double max_cosine_falloff(LightKind kind, const glm::vec3& n, const glm::vec3& from,
                            const Box& box, double d2) const override {
    Box edge = box; // the one along x at the lowest y and z
    edge.hi.y = edge.lo.y;
    edge.hi.z = edge.lo.z;
    const double whole = Library::max_cosine_falloff(kind, n, from, box, d2);
    const double on_edge = Library::max_cosine_falloff(kind, n, from, edge, d2);
    if (on_edge < whole || box.lo.x == box.hi.x) return whole;
    return std::max(Library::max_cosine_falloff(kind, n, from, {edge.lo, edge.lo}, d2),
                    Library::max_cosine_falloff(kind, n, from, {edge.hi, edge.hi}, d2));
  }
};

struct ThresholdOnePercentLoose : StoppingRule {
  static bool obeys(const glm::vec3& bound, const glm::dvec3& total, const CutConfig& config) {
    return StoppingRule::obeys(bound / 1.01F, total, config);
  }
};

/// Two channels of three.
struct BlueIgnored : StoppingRule {
  static bool obeys(const glm::vec3& bound, const glm::dvec3& total, const CutConfig& config) {
    return StoppingRule::obeys({bound.r, bound.g, 0}, total, config);
  }
};

/// A tree of the library that answers one thing another way.
class LowerBoundOneUlpUp : public CopiedPerThread<LowerBoundOneUlpUp> {
public:
  using CopiedPerThread<LowerBoundOneUlpUp>::CopiedPerThread;
  glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point) override {
    glm::vec3 low = LibraryTree::lower_bound(node, point);
    for (int c = 0; c < 3; ++c)
      if (low[c] > 0) low[c] = std::nextafter(low[c], 2 * low[c]);
    return low;
  }
};

class CertifiedWithoutRounding : public CopiedPerThread<CertifiedWithoutRounding> {
public:
  using CopiedPerThread<CertifiedWithoutRounding>::CopiedPerThread;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, config, visible);
    glm::dvec3 bounds(0);
    for (const CutCluster& c : cut.clusters) bounds += glm::dvec3(c.bound);
    for (int c = 0; c < 3; ++c) cut.certified_error[c] = round_up(bounds[c]);
    return cut;
  }
};

/// Totals of clusters kept as floats.
class IntensityInFloats : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    const LightTree tree = lightcuts::build(lights, {seed});
    std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
    for (TreeNode& node : nodes) node.intensity = glm::dvec3(glm::vec3(node.intensity));
    return std::make_unique<LibraryTree>(LightTree(lights, std::move(nodes)));
  }
};

std::unique_ptr<Subject> intensity_in_floats(const char* name) {
  return std::make_unique<IntensityInFloats>(name);
}

constexpr Mutant subtle_catalogue[] = {
    {"bound-one-ulp-down", "the bound is the float below the right one",
     with_kernel<Altered<one_ulp_down>>},
    {"bound-halved-on-faces", "the bound is right but where the point lies in the plane of a face",
     with_suprema<HalvedOnFaces>},
    {"normal-taken-for-unit", "does not divide by the normal's length, which is 1 to a millionth",
     with_suprema<NormalTakenForUnit>},
    {"clamp-one-per-mille", "clamps d^2 in the bound by 0.1 % more than in shading",
     with_suprema<ClampOnePerMille>},
    {"cone-one-in-a-million", "orientation cones are a millionth too narrow",
     with_suprema<ConeOneInAMillion>},
    {"axes-taken-for-one", "takes axes less than a thousandth apart for one",
     with_suprema<AxesTakenForOne>},
    {"estimate-of-another", "estimates a cluster by a light of another one",
     with_kernel<EstimateOfSibling>},
    {"estimate-of-half", "estimates a cluster by its first child alone",
     with_kernel<EstimateOfHalf>},
    {"box-one-ulp-short", "boxes end one float before their lights in x",
     with_suprema<BoxOneUlpShort>},
    {"one-edge-forgotten", "looks for the largest n.l/d^2 on eleven of the box's twelve edges",
     with_suprema<OneEdgeForgotten>},
    {"mixed-by-larger", "bounds lights of several kinds by the brighter kind",
     with_kernel<Altered<larger_of_mixed>>},
    {"threshold-one-percent-loose", "stops at 1.01 times the threshold",
     with_rule<ThresholdOnePercentLoose>},
    {"blue-ignored", "compares two channels of three with the threshold", with_rule<BlueIgnored>},
    {"lower-bound-one-ulp-up", "the lower bound is the float above the right one",
     with_tree<LowerBoundOneUlpUp>},
    {"certified-without-rounding", "the certified error leaves rounding out",
     with_tree<CertifiedWithoutRounding>},
    {"intensity-in-floats", "keeps the totals of clusters as floats", intensity_in_floats},
};

} // namespace

std::span<const Mutant> subtle_mutants() { return subtle_catalogue; }

} // namespace lightcuts::oracle
