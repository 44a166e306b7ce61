// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {
namespace {

// Larger clusters are seldom left unrefined, and what they take grows with their size.
constexpr std::uint32_t most_lights = 64;
// Fewer do not make a mean: single clusters are estimated worse than by chance.
constexpr int least_clusters = 48;
// By which an estimate of a small cluster may be worse in the mean, and the least that is of any
// interest.
constexpr double factor = 4, least_error = 0.05;

/// Sums of relative errors, each counted as 1 at most.
struct MeanErrors {
  double estimates = 0, representatives = 0;
  int clusters = 0;
};

/// Relative error of the estimate, and the mean of that of one light in place of all, drawn by
/// intensity.
void add(const PointAnswers& of, std::uint32_t node, MeanErrors& sums) {
  const Wide& truth = of.at.truth.open(node);
  const auto c = std::size_t(std::max_element(truth.begin(), truth.end()) - truth.begin());
  const glm::vec3& bound = of.bounds()[node];
  if (!(truth[c] > 0x1p-100L) || !std::isfinite(bound[int(c)])) return;
  const LightSet& lights = of.at.lights();
  const auto members = of.topology().all_lights(node);
  long double total = 0;
  for (const std::uint32_t i : members) total += lights[i].intensity[int(c)];
  const auto error = [&](long double estimate) {
    return double(std::min(1.0L, std::abs(estimate - truth[c]) / truth[c]));
  };
  for (const std::uint32_t i : members) {
    const long double share = lights[i].intensity[int(c)] / total;
    if (share > 0)
      sums.representatives += double(share) * error(of.at.truth.of_light(i)[c] / share);
  }
  sums.estimates += error(of.open_estimate(node)[int(c)]);
  ++sums.clusters;
}

/// Of all clusters of a tree together: one may be estimated as badly as its bound allows.
void check_estimates(const PointAnswers& of, NodeRange nodes, const Recorder& record) {
  const Topology& tree = of.topology();
  if (nodes.begin != 0 || nodes.end != tree.size() || tree.size() <= least_clusters) return;
  MeanErrors sums;
  for (std::uint32_t i = 0; i < tree.size(); ++i)
    if (tree.light_count(i) > 1 && tree.light_count(i) <= most_lights) add(of, i, sums);
  if (sums.clusters < least_clusters) return;
  const double mean = sums.estimates / sums.clusters;
  const double allowed = std::max(least_error, factor * sums.representatives / sums.clusters);
  record(mean <= allowed, mean / allowed, [&] {
    return fmt::format(
        "{}: estimates of {} clusters err by {:.3g} % in the mean, one light of each "
        "by {:.3g} %",
        of.at.text(), sums.clusters, 100 * mean, 100 * sums.representatives / sums.clusters);
  });
}

} // namespace

const PropertyInfo property::estimates_match_clusters{
    .name = "estimates-match-clusters",
    .statement =
        "Clusters of up to 64 lights are estimated about as well as by one of their lights.",
    .formula = "mean relative error of the estimates, each 1 at most <= 4 times that of a light "
               "drawn by intensity, or 0.05; of 48 clusters or more",
    .severity = Severity::waste,
    .needs = only(Part::bounds) | only(Part::estimates),
    .of_clusters = check_estimates,
};

} // namespace lightcuts::oracle
