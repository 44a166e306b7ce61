// SPDX-License-Identifier: MIT
#include <oracle/properties/case_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <oracle/truth/naive_tree.h>

namespace lightcuts::oracle {
namespace {

std::string at_point(const PointCase& at) {
  const glm::vec3& x = at.point.position();
  return fmt::format("point ({:.9g}, {:.9g}, {:.9g})", x.x, x.y, x.z);
}

std::string text_of(const glm::vec3& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

/// Whether each cluster of `fine` lies in one of `coarse`, both being cuts.
bool refines(const Topology& tree, const std::vector<std::uint32_t>& fine,
             const std::vector<std::uint32_t>& coarse) {
  std::vector<bool> allowed(tree.size(), false);
  for (const std::uint32_t node : coarse)
    if (node < tree.size()) allowed[node] = true;
  for (const std::uint32_t node : tree.parents_first())
    if (allowed[node])
      for (const std::uint32_t child : tree.children(node)) allowed[child] = true;
  return std::all_of(fine.begin(), fine.end(),
                     [&](std::uint32_t node) { return node < tree.size() && allowed[node]; });
}

std::vector<std::uint32_t> nodes_of(const Cut& cut) {
  std::vector<std::uint32_t> nodes;
  for (const CutCluster& c : cut.clusters) nodes.push_back(c.node);
  return nodes;
}

CutConfig exact_cut(const LightSet& lights) { return {0, std::uint32_t(lights.size()), 0}; }

bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
  for (int c = 0; c < 3; ++c)
    if (!(a[c] == b[c]) && !(std::isnan(a[c]) && std::isnan(b[c]))) return false;
  return true;
}

// ---- what differs between two trees that should be the same; nothing where they agree

std::string differing_cluster(const Judged& judged, SubjectTree& other, const PointCase& at) {
  if (!judged.has(Part::bounds)) return {};
  // All at once: single answers may be kept from the last time.
  std::vector<glm::vec3> bounds(at.topology().size()), again(bounds.size());
  judged.tree.bounds(at.point, bounds);
  other.bounds(at.point, again);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    if (!same_bits(bounds[i], again[i])) return fmt::format("bound of node {}", i);
    if (judged.has(Part::estimates) && !same_bits(judged.tree.estimate(i, at.point, bounds[i]),
                                                  other.estimate(i, at.point, bounds[i])))
      return fmt::format("estimate of node {}", i);
  }
  return {};
}

std::string differing_cut(const Judged& judged, SubjectTree& other, const CutConfig& config,
                          const PointCase& at) {
  if (!judged.has(Part::cuts)) return {};
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  const Cut cut = judged.tree.select(at.point, config, visible);
  const glm::vec3 radiance = cut.radiance, error = cut.certified_error;
  const std::vector<std::uint32_t> clusters = nodes_of(cut);
  const Cut again = other.select(at.point, config, visible);
  const bool same = same_bits(radiance, again.radiance) && same_bits(error, again.certified_error);
  return same && clusters == nodes_of(again) ? "" : "cut";
}

std::string differing_draw(const Judged& judged, SubjectTree& other, const PointCase& at) {
  if (!judged.has(Part::sampling)) return {};
  for (const double u : {0.0, 0.3, 0.7, 1 - 0x1p-53}) {
    const DrawnLight a = judged.tree.sample(0, at.point, u), b = other.sample(0, at.point, u);
    if (a.light != b.light || a.probability != b.probability)
      return fmt::format("light drawn by u = {}", u);
  }
  return {};
}

} // namespace

void check_cost(const Topology& topology, const LightSet& lights, std::uint64_t place,
                Tally& tally) {
  constexpr std::size_t most = 12; // the naive tree takes N^3
  const LightKinds kinds = lights.kinds();
  if (lights.size() > most || (kinds & (kinds - 1)) != 0) return;
  const double cost = tree_cost(topology, lights);
  const double naive = naive_tree_cost(lights);
  if (!std::isfinite(naive)) return;
  const double allowed = naive * (1 + 0x1p-40);
  tally.record(Property::tree_equals_naive, cost <= allowed, place, ratio_of(cost, allowed),
               [&] { return fmt::format("cost {:.9g}, of the naive tree {:.9g}", cost, naive); });
}

void check_nesting(const Judged& judged, const CutConfig& cut, const PointCase& at, Tally& tally) {
  CutConfig coarse = cut, fine = cut;
  coarse.black_level = fine.black_level = 0;
  fine.threshold = cut.threshold / 4;
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  if (fine.threshold == 0) return;
  const auto coarse_nodes = nodes_of(judged.tree.select(at.point, coarse, visible));
  const auto fine_nodes = nodes_of(judged.tree.select(at.point, fine, visible));
  tally.record(Property::tighter_threshold_refines,
               refines(at.topology(), fine_nodes, coarse_nodes), at.place, no_ratio, [&] {
                 return fmt::format("{}: the cut of {} clusters at threshold {} does not refine "
                                    "that of {} at {}",
                                    at_point(at), fine_nodes.size(), fine.threshold,
                                    coarse_nodes.size(), coarse.threshold);
               });
}

void check_darkening(const Judged& judged, const PointCase& at, Tally& tally) {
  const CutConfig exact = exact_cut(at.lights());
  const glm::vec3 all =
      judged.tree.select(at.point, exact, [](std::uint32_t) { return true; }).radiance;
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  const glm::vec3 seen = judged.tree.select(at.point, exact, visible).radiance;
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (all[c] == std::numeric_limits<float>::infinity()) continue;
    // Both sums round.
    const double allowed = double(all[c]) + 2 * double(certified_error(all[c], 0));
    holds = holds && seen[c] <= allowed;
    worst = std::max(worst, ratio_of(seen[c], allowed));
  }
  tally.record(Property::visibility_only_darkens, holds, at.place, worst, [&] {
    return fmt::format("{}: radiance {}, with all lights seen {}", at_point(at), text_of(seen),
                       text_of(all));
  });
}

void check_refinement_order(const Subject& subject, std::uint64_t place, Tally& tally) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 6> bounds{0, 0x1p-149, 1, 1 + 0x1p-23, 0x1.fffffep127, inf};
  const auto before = [&](double a, double b) { return subject.refined_before(a, b); };
  const auto fail = [&](double a, double b, const char* what) {
    tally.record(Property::refinement_order_is_strict, false, place, no_ratio,
                 [&] { return fmt::format("bounds {} and {}: {}", a, b, what); });
  };
  for (const double a : bounds)
    for (const double b : bounds) {
      if (before(a, b) && before(b, a)) return fail(a, b, "each is refined before the other");
      for (const double c : bounds) {
        if (before(a, b) && before(b, c) && !before(a, c))
          return fail(a, c, "not before, but something lies between");
        const bool ab = before(a, b) || before(b, a), bc = before(b, c) || before(c, b);
        if (!ab && !bc && (before(a, c) || before(c, a)))
          return fail(a, c, "differ, but both tie with a third");
      }
    }
  tally.record(Property::refinement_order_is_strict, true, place, no_ratio,
               [] { return std::string(); });
}

void check_agreement(const Judged& judged, const CutConfig& cut, const PointCase& at,
                     Tally& tally) {
  const std::unique_ptr<SubjectTree> other = judged.tree.for_another_thread();
  std::string difference;
  const auto compare = [&](SubjectTree& tree, const char* who) {
    for (const auto& what :
         {differing_cluster(judged, tree, at), differing_cut(judged, tree, cut, at),
          differing_draw(judged, tree, at)})
      if (difference.empty() && !what.empty())
        difference = fmt::format("{}: another {} from {}", at_point(at), what, who);
  };
  compare(judged.tree, "the same tree, asked again");
  compare(*other, "another thread's tree");
  tally.record(Property::threads_agree, difference.empty(), at.place, no_ratio,
               [&] { return difference; });
}

} // namespace lightcuts::oracle
