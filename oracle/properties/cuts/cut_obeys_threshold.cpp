// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

/// What may be wrong with the cluster, at most: its bound. A leaf cannot be refined: of one light
/// it is exact, of several what counts is how far it is off, but for rounding as in
/// zero-threshold-is-exact.
Wide possible_error(const CutAnswer& of, const CutCluster& cluster, const Wide& bound) {
  const PointAnswers& answers = of.point;
  Wide error{};
  if (answers.topology().light_count(cluster.node) == 1) return error;
  if (!answers.topology().is_leaf(cluster.node)) return bound;
  const Wide& exact = answers.at.truth.seen(cluster.node);
  for (int i = 0; i < 3; ++i) {
    const long double off = std::abs(cluster.estimate[i] - exact[std::size_t(i)]);
    const long double rounding = certified_error(double(exact[std::size_t(i)]), 0);
    error[std::size_t(i)] = off <= rounding ? 0 : off;
  }
  return error;
}

/// The cluster whose possible error exceeds what is allowed the most.
struct WorstCluster {
  bool holds = true;
  double ratio = 0;
  std::uint32_t node = 0;
  bool needs_black_level = false; ///< some bound, of a leaf or not, is above the threshold
  bool needs_more = false;        ///< and above the black level

  explicit WorstCluster(const CutAnswer& of) {
    for (const CutCluster& c : of.cut.clusters) {
      if (c.node >= of.point.topology().size()) continue; // convicted elsewhere
      const glm::vec3& own = of.point.bounds()[c.node];
      const Wide bound{own.x, own.y, own.z}, error = possible_error(of, c, bound);
      for (std::size_t i = 0; i < 3; ++i) {
        const long double exact = of.config.threshold * of.total[i];
        const long double relative = exact * (1 + of.sum_error());
        const bool needs_black = bound[i] > 0 && bound[i] >= exact * (1 - of.sum_error());
        needs_black_level = needs_black_level || needs_black;
        needs_more = needs_more || (needs_black && bound[i] > of.config.black_level);
        const bool by_total = of.cut.end == CutEnd::converged;
        const long double allowed =
            by_total ? relative : std::max<long double>(relative, of.config.black_level);
        holds = holds && error[i] <= allowed;
        if (const double r = ratio_of(error[i], allowed); r > ratio) {
          ratio = r;
          node = c.node;
        }
      }
    }
  }
};

/// By how many clusters the cut may grow where one is refined, 1 at least: a node may have any
/// number of children, so that the next cut may be too large before this one has the largest size.
std::size_t largest_step(const CutAnswer& of) {
  std::size_t children = 2;
  for (const CutCluster& c : of.cut.clusters)
    if (c.node < of.point.topology().size())
      children = std::max(children, of.point.topology().children(c.node).size());
  return children - 1;
}

/// What is wrong with the reason that is given for the end, if anything.
std::string wrong_end(const CutAnswer& of, const WorstCluster& worst) {
  switch (of.cut.end) {
  case CutEnd::max_size:
    if (of.cut.clusters.size() + largest_step(of) <= of.config.max_size)
      return "ended by its largest size before that";
    return worst.needs_more ? "" : "ended by its largest size, though all clusters obey";
  case CutEnd::black_level:
    return worst.needs_black_level ? "" : "ended by the black level, which no cluster needs";
  case CutEnd::converged:
    break;
  }
  return {};
}

void check_threshold(const CutAnswer& of, const Recorder& record) {
  const std::size_t size = of.cut.clusters.size();
  const WorstCluster worst(of);
  const std::string end = wrong_end(of, worst);
  const bool full = of.cut.end == CutEnd::max_size;
  record(size <= of.config.max_size && end.empty() && (full || worst.holds), full ? 0 : worst.ratio,
         [&] {
           if (!end.empty())
             return fmt::format("{}: cut of {} (at most {}) {}", of.point.at.text(), size,
                                of.config.max_size, end);
           return fmt::format("{}: cut of {} (at most {}) with node {} at {:.6g} times what the "
                              "threshold {} allows",
                              of.point.at.text(), size, of.config.max_size, worst.node, worst.ratio,
                              of.config.threshold);
         });
}

std::string parting(const CutAnswer& of) {
  if (of.cut.clusters.size() > of.config.max_size) return {};
  const WorstCluster worst(of);
  if (worst.ratio <= 1) return "the cut " + wrong_end(of, worst);
  return fmt::format("the bound of node {} is {:.6g} times what is allowed, and yet refinement "
                     "ended with {} clusters of at most {}",
                     worst.node, worst.ratio, of.cut.clusters.size(), of.config.max_size);
}

} // namespace

const PropertyInfo property::cut_obeys_threshold{
    .name = "cut-obeys-threshold",
    .statement = "Unless the largest size was reached, every cluster's bound is within the "
                 "threshold; and a cut ends by what it says.",
    .formula = "bound (of a leaf: error) <= max(threshold * total, black level), per channel; cut "
               "size <= largest size",
    .needs = only(Part::cuts) | only(Part::bounds),
    .of_cut = check_threshold,
    .parting = parting,
};

} // namespace lightcuts::oracle
