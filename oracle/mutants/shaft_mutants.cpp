// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <oracle/mutants/groups.h>
#include <oracle/subjects/proven_sights.h>

namespace lightcuts::oracle {
namespace {

/// The library but for what it proves.
template <class Rules>
class OtherProofs : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::vector<ProvenSight>
  prove(const SceneView& view, const LightTree& tree,
        std::span<const VisiblePoint> points) const override {
    return proven_sights<Rules>(view, tree, points);
  }
};

template <class Rules>
std::unique_ptr<Subject> with_proofs(const char* name) {
  return std::make_unique<OtherProofs<Rules>>(name);
}

glm::vec3 middle_of(const Box& box) { return box.lo + 0.5F * (box.hi - box.lo); }

struct ShaftToTheMiddle : ShaftRules {
  static Shaft shaft(const Box& from, const Box& to) {
    return {from, {middle_of(to), middle_of(to)}};
  }
};

glm::vec3 corner_of(const Box& box, int k) {
  return {(k & 1) != 0 ? box.hi.x : box.lo.x, (k & 2) != 0 ? box.hi.y : box.lo.y,
          (k & 4) != 0 ? box.hi.z : box.lo.z};
}

/// A box or a triangle is out of the way where it touches the shaft or its own plane has all on one
/// side, whatever rounding did.
struct NoMargin : ShaftRules {
  static double margin() { return 0; }
  static bool misses(const FlatTriangle& triangle, const RayEnds& ends, double separation) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    const auto add = [&](const glm::dvec3& end) {
      lo = std::min(lo, triangle.height(end));
      hi = std::max(hi, triangle.height(end));
    };
    for (int k = 0; k < 8; ++k) add(corner_of(ends.to, k));
    for (const glm::dvec3& origin : ends.origins) add(origin);
    return separation >= 0 || lo >= 0 || hi <= 0;
  }
};

struct CoveredAtTheMiddle : ShaftRules {
  static bool covers(const FlatTriangle& triangle, const FlatTriangle& partner,
                     const RayEnds& ends) {
    RayEnds middle;
    const glm::vec3 from = middle_of(ends.from), to = middle_of(ends.to);
    middle.start_at({&from, 1});
    middle.end_in({to, to});
    return certainly_covers(triangle, partner, middle);
  }
};

/// What lies in the way of a cluster is looked for among what lay in the way of the one asked for
/// before, be it elsewhere.
struct CandidatesOfAnother : ShaftRules {
  static std::uint32_t inherited(const ProvenVisibility::Proof& within) {
    static thread_local std::uint32_t before = 0;
    if (within.candidates == 0) before = 0;
    return std::exchange(before, within.candidates);
  }
};

/// Only the first of the points is tested against a triangle's plane.
struct PlaneOfTheFirstPoint : ShaftRules {
  static bool misses(const FlatTriangle& triangle, const RayEnds& ends, double separation) {
    RayEnds first = ends;
    first.origins.resize(std::min<std::size_t>(first.origins.size(), 1));
    return certainly_missed(triangle, first, separation);
  }
};

/// Two triangles are taken to block what either of them, made larger by the other, may let through.
struct PartnerFromAfar : ShaftRules {
  static bool covers(const FlatTriangle& triangle, const FlatTriangle& partner,
                     const RayEnds& ends) {
    if (&triangle == &partner) return certainly_covers(triangle, partner, ends);
    RayEnds shrunk;
    std::vector<glm::vec3> origins;
    for (const glm::dvec3& origin : ends.origins) origins.emplace_back(origin);
    shrunk.start_at(origins);
    shrunk.end_in({middle_of(ends.to), middle_of(ends.to)});
    return certainly_covers(triangle, partner, shrunk);
  }
};

constexpr Mutant shaft_catalogue[] = {
    {"shaft-to-the-middle", "lets the shaft to a cluster end at the middle of its box",
     with_proofs<ShaftToTheMiddle>},
    {"shaft-without-margin", "allows for no rounding where a triangle touches a shaft",
     with_proofs<NoMargin>},
    {"covered-at-the-middle",
     "takes a cluster for hidden where the middles of both boxes do not "
     "see each other",
     with_proofs<CoveredAtTheMiddle>},
    {"candidates-of-another", "looks for what hides a cluster among what hides another one",
     with_proofs<CandidatesOfAnother>},
    {"plane-of-the-first-point", "tests the first of a block's points against a triangle's plane",
     with_proofs<PlaneOfTheFirstPoint>},
    {"pair-hides-the-middle",
     "takes two triangles for opaque to all of a cluster that are to its "
     "middle",
     with_proofs<PartnerFromAfar>},
};

} // namespace

std::span<const Mutant> shaft_mutants() { return shaft_catalogue; }

} // namespace lightcuts::oracle
