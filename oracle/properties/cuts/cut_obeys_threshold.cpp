// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

/// The cluster whose bound exceeds what is allowed the most.
struct WorstCluster {
  bool holds = true;
  double ratio = 0;
  std::uint32_t node = 0;

  WorstCluster() = default;
  explicit WorstCluster(const CutAnswer& of) {
    const PointAnswers& answers = of.point;
    for (const CutCluster& c : of.cut.clusters) {
      // A cluster of one light is exact; what is no node is convicted elsewhere.
      if (c.node >= answers.topology().size() || answers.topology().light_count(c.node) == 1)
        continue;
      const glm::vec3 bound = answers.judged.tree.bound(c.node, answers.at.point);
      for (int i = 0; i < 3; ++i) {
        const long double relative = of.config.threshold * of.total[i] * (1 + of.sum_error());
        const long double allowed = std::max<long double>(relative, of.config.black_level);
        holds = holds && bound[i] <= allowed;
        if (const double r = ratio_of(bound[i], allowed); r > ratio) {
          ratio = r;
          node = c.node;
        }
      }
    }
  }
};

void check(const CutAnswer& of, const Recorder& record) {
  const std::size_t size = of.cut.clusters.size();
  const bool claims_full = of.cut.end == CutEnd::max_size;
  const bool full = size >= of.config.max_size && claims_full;
  const bool sized = size <= of.config.max_size && (full || !claims_full);
  const WorstCluster worst = full ? WorstCluster() : WorstCluster(of);
  record(sized && worst.holds, worst.ratio, [&] {
    return fmt::format("{}: cut of {} (at most {}) with node {} at {:.6g} times what the "
                       "threshold {} allows",
                       of.point.at.text(), size, of.config.max_size, worst.node, worst.ratio,
                       of.config.threshold);
  });
}

std::string parting(const CutAnswer& of) {
  if (of.cut.clusters.size() > of.config.max_size) return {};
  const WorstCluster worst(of);
  return fmt::format("the bound of node {} is {:.6g} times what is allowed, and yet refinement "
                     "ended with {} clusters of at most {}",
                     worst.node, worst.ratio, of.cut.clusters.size(), of.config.max_size);
}

} // namespace

const PropertyInfo property::cut_obeys_threshold{
    .name = "cut-obeys-threshold",
    .statement = "Unless the largest size was reached, every cluster's bound is within the "
                 "threshold.",
    .formula = "bound <= max(threshold * total, black level), per channel; cut size <= largest "
               "size",
    .needs = only(Part::cuts) | only(Part::bounds),
    .of_cut = check,
    .parting = parting,
};

} // namespace lightcuts::oracle
